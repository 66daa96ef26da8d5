#include "recognition/smooth_profile.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"
#include "recognition/median.h"

namespace geon::recognition {
namespace {

// As RunningMedian, with the weights of a normal distribution.
void RunningMean(std::span<const double> values, int half_width, double sigma,
                 std::span<double> means) {
  for (size_t i = 0; i < values.size(); ++i) {
    const size_t reach = std::min({static_cast<size_t>(half_width), i, values.size() - 1 - i});
    double sum = 0.0;
    double weights = 0.0;
    for (size_t j = i - reach; j <= i + reach; ++j) {
      const double offset = static_cast<double>(j) - static_cast<double>(i);
      const double weight = std::exp(-0.5 * offset * offset / (sigma * sigma));
      sum += weight * values[j];
      weights += weight;
    }
    means[i] = sum / weights;
  }
}

}  // namespace

void SmoothingOptions::Validate() const {
  Require(half_width_px >= 0, "smoothing half_width_px", half_width_px, "must not be negative");
  Require(gaussian_sigma_px > 0.0, "gaussian_sigma_px", gaussian_sigma_px, "must be positive");
}

std::vector<double> SmoothDepths(std::span<const int> pixel, std::span<const double> depth_m,
                                 const SmoothingOptions& options) {
  std::vector<double> smooth_m(depth_m.begin(), depth_m.end());
  if (options.kind == Smoothing::kNone) return smooth_m;
  size_t begin = 0;
  for (size_t end = 1; end <= pixel.size(); ++end) {  // runs without a missing pixel
    if (end < pixel.size() && pixel[end] - pixel[end - 1] == 1) continue;
    const auto run_m = depth_m.subspan(begin, end - begin);
    const auto smooth_run_m = std::span(smooth_m).subspan(begin, end - begin);
    if (options.kind == Smoothing::kMedian) {
      RunningMedian(run_m, options.half_width_px, smooth_run_m);
    } else {
      RunningMean(run_m, options.half_width_px, options.gaussian_sigma_px, smooth_run_m);
    }
    begin = end;
  }
  return smooth_m;
}

}  // namespace geon::recognition
