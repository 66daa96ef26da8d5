#include "evaluation/threshold_search.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"
#include "evaluation/open_thresholds.h"
#include "evaluation/trial_random.h"
#include "recognition/recognize_geon.h"

namespace geon::evaluation {
namespace {

using recognition::RecognitionOptions;

// Two significant digits; whole numbers stay whole.
double Rounded(double value, bool integer) {
  if (integer) return std::round(value);
  if (value == 0.0) return 0.0;
  const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
  return std::round(value / digit) * digit;
}

bool IsValid(const RecognitionOptions& options) {
  try {
    options.Validate();
    return true;
  } catch (const ContractViolation&) {
    return false;
  }
}

void SetRounded(const Threshold& threshold, double value, RecognitionOptions* options) {
  threshold.set(options,
                Rounded(std::clamp(value, threshold.low, threshold.high), threshold.integer));
}

RecognitionOptions DrawAll(const std::vector<Threshold>& thresholds, RecognitionOptions options,
                           std::mt19937_64& random) {
  for (const Threshold& threshold : thresholds) {
    std::uniform_real_distribution<double> uniform(threshold.low, threshold.high);
    SetRounded(threshold, uniform(random), &options);
  }
  return options;
}

// One to three thresholds move by about `reach` of their ranges.
RecognitionOptions MoveSome(const std::vector<Threshold>& thresholds, RecognitionOptions options,
                            double reach, std::mt19937_64& random) {
  std::normal_distribution<double> gauss;
  const int count = 1 + static_cast<int>(random() % 3);
  for (int k = 0; k < count; ++k) {
    const Threshold& threshold = thresholds[random() % thresholds.size()];
    const double step = reach * (threshold.high - threshold.low) * gauss(random);
    SetRounded(threshold, threshold.get(options) + step, &options);
  }
  return options;
}

// The rate over all scans; given up after a quarter of them when it is hopeless against `best`.
SuccessRate RateAgainst(std::span<const sensor::ScanSet> scans, const RecognitionOptions& options,
                        const SuccessRate& best) {
  constexpr double kHopeless = 0.03;
  const std::span<const sensor::ScanSet> quarter = scans.first(scans.size() / 4);
  const SuccessRate first = RecognitionRate(quarter, options);
  if (first.value_1() < best.value_1() - kHopeless) return {0, static_cast<int>(scans.size())};
  const SuccessRate rest = RecognitionRate(scans.subspan(quarter.size()), options);
  return {first.right + rest.right, first.n + rest.n};
}

}  // namespace

ThresholdSearchResult SearchThresholds(
    std::span<const sensor::ScanSet> scans, const RecognitionOptions& start,
    const ThresholdSearchOptions& options,
    const std::function<void(int step, const SuccessRate& best)>& progress) {
  const std::vector<Threshold> thresholds = OpenThresholds(start.curvature);
  std::mt19937_64 random = TrialRandom(options.seed, 0);
  ThresholdSearchResult best{start, RecognitionRate(scans, start)};
  progress(0, best.training);
  for (int step = 1; step <= options.draws + options.steps; ++step) {
    const double done_1 = static_cast<double>(step - options.draws) / std::max(options.steps, 1);
    const RecognitionOptions tried =
        step <= options.draws
            ? DrawAll(thresholds, start, random)
            : MoveSome(thresholds, best.options, 0.3 * std::pow(0.1, done_1), random);
    if (!IsValid(tried)) continue;
    const SuccessRate rate = RateAgainst(scans, tried, best.training);
    if (rate.right < best.training.right) continue;
    const bool better = rate.right > best.training.right;
    best = {tried, rate};  // as good is good enough: it lets the search drift along plateaus
    if (better) progress(step, rate);
  }
  return best;
}

SuccessRate RecognitionRate(std::span<const sensor::ScanSet> scans,
                            const RecognitionOptions& options) {
  SuccessRate rate;
  for (const sensor::ScanSet& scan : scans) {
    rate.Count(recognition::RecognizeGeon(scan, options).label == scan.truth);
  }
  return rate;
}

}  // namespace geon::evaluation
