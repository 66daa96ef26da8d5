#include "evaluation/reliability.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/contracts.h"

namespace geon::evaluation {
namespace {

size_t BinOf(double confidence_1) {
  const int bin = static_cast<int>(std::ceil(confidence_1 * kReliabilityBins)) - 1;
  return static_cast<size_t>(std::clamp(bin, 0, kReliabilityBins - 1));
}

}  // namespace

Reliability MeasureReliability(std::span<const Prediction> predictions) {
  Reliability result;
  for (const Prediction& prediction : predictions) {
    Require(prediction.confidence_1 >= 0.0 && prediction.confidence_1 <= 1.0,
            "a confidence lies within 0 and 1, is " + std::to_string(prediction.confidence_1));
    ReliabilityBin& bin = result.bins[BinOf(prediction.confidence_1)];
    bin.mean_confidence_1 += prediction.confidence_1;  // the sum, as yet
    bin.rate.Count(prediction.right);
    result.all.Count(prediction.right);
    (prediction.decided ? result.decided : result.undecided).Count(prediction.right);
  }
  for (int m = 0; m < kReliabilityBins; ++m) {
    ReliabilityBin& bin = result.bins[static_cast<size_t>(m)];
    bin.low_1 = static_cast<double>(m) / kReliabilityBins;
    bin.high_1 = static_cast<double>(m + 1) / kReliabilityBins;
    if (bin.rate.n == 0) continue;
    bin.mean_confidence_1 /= bin.rate.n;
    result.expected_calibration_error_1 +=
        std::abs(bin.rate.value_1() - bin.mean_confidence_1) * bin.rate.n / result.all.n;
  }
  return result;
}

std::vector<Prediction> PredictionsOf(std::span<const Subject> subjects,
                                      std::span<const ShapeTrial> trials) {
  std::vector<Prediction> predictions;
  predictions.reserve(trials.size());
  for (const ShapeTrial& trial : trials) {
    const GeonLabel truth = subjects[static_cast<size_t>(trial.subject)].truth;
    predictions.push_back({trial.confidence, trial.answer == truth, trial.decided});
  }
  return predictions;
}

}  // namespace geon::evaluation
