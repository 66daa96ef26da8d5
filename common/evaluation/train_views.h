#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "active_vision/view_table.h"
#include "evaluation/train_forest.h"
#include "evaluation/view_report.h"
#include "evaluation/view_round.h"

namespace geon::evaluation {

// How it is learned what another look tells. Numbers of shapes, each seen from all round.
struct ViewTrainingOptions {
  uint64_t seed = 1;
  int shapes = 8000;              // of training: the gains
  int calibration_shapes = 3000;  // of training: the weight
  int ordinary_shapes = 8000;     // from when on an answer is decided
  int held_out_shapes = 4000;     // of training, and as many ordinary ones: the report
};

struct ViewTrainingReport {
  int learned_from = 0;  // looks that did not decide
  int weighted_by = 0;
  int decided_by = 0;
  double decided_right_1 = 0.0;   // of the decided answers so many are right: the lower bound
  ViewReport training, ordinary;  // on rounds held out
};

// Learns from rounds of views of random shapes (view_round.h), of their looks that do not decide:
// 1. the weight of each view, by the likelihood of the truth after a second look from anywhere (a
//    third is rare);
// 2. the mean gain in log posterior of the truth, by the two likeliest labels in their order and by
//    turn. What few looks tell is drawn to what more do: a pair's mean counts as if 100 looks with
//    its likeliest label's mean were among its own, and that label's with the mean of all;
// 3. the least posterior from which on more than 99 % of the decided answers are right, by the
//    lower end of Wilson's interval, when ordinary shapes are looked at as the table says; where
//    that is not reached, the posterior with the highest lower end.
// Each step has rounds of its own. Depends on the options alone, not on how `for_each` goes about
// it.
//
// Source: ours; Arbel and Ferrie, ICCV 1999, learn the same as maps of entropy.
active_vision::ViewTable TrainViews(const ViewTrainingOptions& options, const ForEach& for_each,
                                    ViewTrainingReport* report);

// The steps.
double FitViewWeight(std::span<const ViewRound> rounds);
active_vision::ViewGainTable MeanViewGains(std::span<const ViewRound> rounds,
                                           const active_vision::FusionOptions& fusion);

// The table as the C++ source that common/active_vision/view_table.cc includes.
std::string ViewTableSource(const active_vision::ViewTable& table,
                            const ViewTrainingOptions& options);

}  // namespace geon::evaluation
