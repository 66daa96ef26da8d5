#pragma once

#include "evaluation/success_rate.h"

namespace geon::evaluation {

// The mean of values that come in clusters whose members are alike: several views of one shape go
// wrong together, so that they tell less than as many views of as many shapes.
//
// Source: Kish 1965, "Survey sampling": were all members of a cluster the same, n of them would
// tell as much as (sum of m)^2 / (sum of m^2) independent ones, m being the clusters' sizes.
class ClusteredMean {
 public:
  void Count(double value_1);  // in the present cluster
  void EndCluster();           // what was counted before belongs to it; without any it is none

  // Of the clusters that have ended; 0 without any.
  int n() const { return n_; }
  int clusters() const { return clusters_; }
  double mean_1() const;
  // At least so many independent values would tell as much.
  double EffectiveN() const;
  // Of a share, whose values are 0 to 1: Wilson's 95 % interval for EffectiveN() trials.
  Interval ShareInterval() const;
  // Of any mean: 95 % by the scatter of the clusters' sums about it.
  Interval MeanInterval() const;

 private:
  struct Cluster {
    double n_1 = 0.0;
    double sum_1 = 0.0;
  } present_;
  int n_ = 0;
  int clusters_ = 0;
  double sum_1_ = 0.0;
  // Over the clusters, of n^2, n * sum and sum^2.
  double nn_1_ = 0.0, ns_1_ = 0.0, ss_1_ = 0.0;
};

}  // namespace geon::evaluation
