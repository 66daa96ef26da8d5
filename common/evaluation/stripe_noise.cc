#include "evaluation/stripe_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geon::evaluation {
namespace {

constexpr double kSpeckleLength_px = 4.0;
constexpr double kOutlierReach_px = 20.0;
constexpr double kEdgeLength_px = 6.0;
constexpr double kJump_m = 0.03;   // a larger step is a jump of depth
constexpr double kMixes_1 = 0.02;  // of lines beside a jump mix both sides

// A first-order autoregression of deviation 1.
class Autoregression {
 public:
  Autoregression(double length_px, std::mt19937_64& random)
      : memory_(std::exp(-1.0 / length_px)), state_(gauss_(random)) {}
  double Next(std::mt19937_64& random) {
    state_ = memory_ * state_ + std::sqrt(1.0 - memory_ * memory_) * gauss_(random);
    return state_;
  }

 private:
  std::normal_distribution<double> gauss_;
  double memory_;
  double state_;
};

// Mean over a patch, of the depths that belong to the surface in its middle; now and then of all.
double PatchMean(std::span<const double> depths_m, std::ptrdiff_t middle, int half, bool mixes) {
  const double depth_m = depths_m[static_cast<size_t>(middle)];
  const auto last = static_cast<std::ptrdiff_t>(depths_m.size()) - 1;
  double sum_m = 0.0, count = 0.0;
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(middle - half, 0);
       i <= std::min(middle + half, last); ++i) {
    const double other_m = depths_m[static_cast<size_t>(i)];
    if (!std::isfinite(other_m) || (!mixes && std::abs(other_m - depth_m) > kJump_m)) continue;
    sum_m += other_m;
    count += 1.0;
  }
  return count > 0.0 ? sum_m / count : depth_m;
}

// Removes the lines within `reach` of a jump, or of a line without depth.
void LoseEdges(std::span<const double> before_m, int reach, std::vector<double>* depths_m) {
  for (size_t i = 1; i < before_m.size(); ++i) {
    const double step_m = before_m[i] - before_m[i - 1];
    if (std::abs(step_m) <= kJump_m) continue;  // the difference of two infinities is not a number
    if (!std::isfinite(before_m[i]) && !std::isfinite(before_m[i - 1])) continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    for (std::ptrdiff_t k = at - reach; k < at + reach; ++k) {
      if (k < 0 || k >= static_cast<std::ptrdiff_t>(depths_m->size())) continue;
      (*depths_m)[static_cast<size_t>(k)] = std::numeric_limits<double>::infinity();
    }
  }
}

}  // namespace

std::vector<StripeError> StripeErrors(size_t lines, const FaultOptions& faults,
                                      std::mt19937_64& random) {
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> uniform;
  Autoregression speckle(kSpeckleLength_px, random);
  std::vector<StripeError> errors(lines);
  for (StripeError& error : errors) {
    error.offset_px = faults.noise_px * gauss(random);
    if (faults.speckle_px > 0.0) {
      error.offset_px += faults.speckle_px * speckle.Next(random);
    }
    if (faults.outliers_1 > 0.0 && uniform(random) < faults.outliers_1) {
      error.offset_px = kOutlierReach_px * (2.0 * uniform(random) - 1.0);
    }
    error.missing = faults.dropout_1 > 0.0 && uniform(random) < faults.dropout_1;
  }
  return errors;
}

std::vector<double> MatchPatches(std::span<const double> depths_m, const FaultOptions& faults,
                                 std::mt19937_64& random) {
  std::vector<double> seen_m(depths_m.begin(), depths_m.end());
  const int half = static_cast<int>(std::lround(faults.patch_px));
  if (half > 0 || faults.edge_px > 0.0) {
    std::uniform_real_distribution<double> uniform;
    Autoregression beside(kEdgeLength_px, random);
    const auto last = static_cast<std::ptrdiff_t>(depths_m.size()) - 1;
    for (std::ptrdiff_t i = 0; i <= last; ++i) {
      const auto middle = std::clamp<std::ptrdiff_t>(
          i + std::lround(faults.edge_px * beside.Next(random)), 0, last);
      const bool mixes = uniform(random) < kMixes_1;
      seen_m[static_cast<size_t>(i)] = PatchMean(depths_m, middle, half, mixes);
    }
  }
  const int shadow = static_cast<int>(std::lround(faults.shadow_px));
  if (shadow > 0) LoseEdges(std::vector<double>(seen_m), shadow, &seen_m);
  return seen_m;
}

}  // namespace geon::evaluation
