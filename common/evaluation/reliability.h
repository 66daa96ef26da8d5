#pragma once

#include <array>
#include <span>
#include <vector>

#include "evaluation/shape_experiment.h"
#include "evaluation/success_rate.h"

namespace geon::evaluation {

// What a recogniser said of one view, as far as its confidence is to be believed.
struct Prediction {
  double confidence_1 = 0.0;  // 0 to 1
  bool right = false;
  bool decided = false;
};

// The predictions whose confidence lies above `low_1` and not above `high_1`.
struct ReliabilityBin {
  double low_1 = 0.0;
  double high_1 = 0.0;
  double mean_confidence_1 = 0.0;  // 0 when there are none
  SuccessRate rate;
};

inline constexpr int kReliabilityBins = 15;

struct Reliability {
  std::array<ReliabilityBin, kReliabilityBins> bins;
  // The mean distance between confidence and success over the bins, each weighed by its
  // predictions: 0 when of 100 answers given with 90 % confidence 90 are right.
  double expected_calibration_error_1 = 0.0;
  SuccessRate all;
  SuccessRate decided;    // right ones among those that the recogniser stands by
  SuccessRate undecided;  // right ones among its guesses
  // Not how many are right but how many were decided.
  SuccessRate decided_share() const { return {decided.n, all.n}; }
};

// Whether "90 % sure" means right nine times out of ten.
//
// Source: Guo et al. 2017, "On calibration of modern neural networks", equations 2, 3 and 5, with
// their 15 bins of equal width ((m - 1)/15, m/15]; after Naeini et al. 2015, "Obtaining well
// calibrated probabilities using Bayesian binning". A confidence of exactly 0 belongs to the first.
//
// Throws ContractViolation for a confidence that is not within 0 and 1.
Reliability MeasureReliability(std::span<const Prediction> predictions);

// The trials of an experiment as predictions, in their order.
std::vector<Prediction> PredictionsOf(std::span<const Subject> subjects,
                                      std::span<const ShapeTrial> trials);

}  // namespace geon::evaluation
