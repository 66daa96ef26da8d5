#include "recognition/smooth_profile.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

// Points [first, last] of the window round point i: pixels within reach, no missing one in between.
struct Window {
  size_t first = 0;
  size_t last = 0;
};

Window WindowAround(const std::vector<int>& pixel, size_t i, int half_width_px) {
  Window window{i, i};
  for (int step = 0; step < half_width_px; ++step) {
    if (window.first > 0 && pixel[window.first] - pixel[window.first - 1] == 1) --window.first;
    if (window.last + 1 < pixel.size() && pixel[window.last + 1] - pixel[window.last] == 1) {
      ++window.last;
    }
  }
  // At an end the window shrinks on both sides, so that a slope is not bent there.
  const size_t reach = std::min(i - window.first, window.last - i);
  return {i - reach, i + reach};
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double WeightedMean(const std::vector<double>& depth_m, Window window, size_t i, double sigma_px) {
  double sum = 0.0;
  double weights = 0.0;
  for (size_t j = window.first; j <= window.last; ++j) {
    const double offset_px = static_cast<double>(j) - static_cast<double>(i);
    const double weight = std::exp(-0.5 * offset_px * offset_px / (sigma_px * sigma_px));
    sum += weight * depth_m[j];
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

void SmoothingOptions::Validate() const {
  Require(half_width_px >= 0,
          "smoothing half_width_px is " + std::to_string(half_width_px) + ", must not be negative");
  Require(gaussian_sigma_px > 0.0,
          "gaussian_sigma_px is " + std::to_string(gaussian_sigma_px) + ", must be positive");
}

sensor::RangeProfile SmoothProfile(const sensor::RangeProfile& profile,
                                   const Eigen::Vector3d& p_LB_m, const Eigen::Matrix3d& R_LB,
                                   const SmoothingOptions& options) {
  options.Validate();
  if (options.kind == Smoothing::kNone) return profile;
  std::vector<double> depth_m;
  depth_m.reserve(profile.p_L_m.size());
  for (const Eigen::Vector3d& p_L : profile.p_L_m) {
    depth_m.push_back(R_LB.col(2).dot(p_L - p_LB_m));
  }
  sensor::RangeProfile smooth = profile;
  for (size_t i = 0; i < depth_m.size(); ++i) {
    if (depth_m[i] <= 0.0) continue;  // behind the camera: has no viewing ray to move along
    const Window window = WindowAround(profile.pixel, i, options.half_width_px);
    const double smoothed_m =
        options.kind == Smoothing::kMedian
            ? Median({depth_m.begin() + static_cast<std::ptrdiff_t>(window.first),
                      depth_m.begin() + static_cast<std::ptrdiff_t>(window.last) + 1})
            : WeightedMean(depth_m, window, i, options.gaussian_sigma_px);
    smooth.p_L_m[i] = p_LB_m + (profile.p_L_m[i] - p_LB_m) * (smoothed_m / depth_m[i]);
  }
  return smooth;
}

}  // namespace geon::recognition
