#include "recognition/difference_of_slope.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::recognition {
namespace {

// Sums over the first k points, relative to the first point of all.
struct Moments {
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
};

std::vector<Moments> CumulativeMoments(std::span<const Eigen::Vector2d> curve_m) {
  std::vector<Moments> sums(curve_m.size() + 1);
  for (size_t i = 0; i < curve_m.size(); ++i) {
    const Eigen::Vector2d p = curve_m[i] - curve_m[0];
    const Moments& s = sums[i];
    sums[i + 1] = {s.x + p.x(), s.y + p.y(), s.xx + p.x() * p.x(), s.xy + p.x() * p.y(),
                   s.yy + p.y() * p.y()};
  }
  return sums;
}

// Direction of the total-least-squares line through each `window` successive points, along the
// walk.
std::vector<double> FittedDirections(std::span<const Eigen::Vector2d> curve_m, size_t window) {
  const std::vector<Moments> sums = CumulativeMoments(curve_m);
  const double n = static_cast<double>(window);
  std::vector<double> directions_rad;
  for (size_t begin = 0; begin + window <= curve_m.size(); ++begin) {
    const Moments& a = sums[begin];
    const Moments& b = sums[begin + window];
    const double x = b.x - a.x, y = b.y - a.y;
    const double xx = b.xx - a.xx - x * x / n;
    const double xy = b.xy - a.xy - x * y / n;
    const double yy = b.yy - a.yy - y * y / n;
    const double angle_rad = 0.5 * std::atan2(2.0 * xy, xx - yy);
    const Eigen::Vector2d walk = curve_m[begin + window - 1] - curve_m[begin];
    const bool backwards = std::cos(angle_rad) * walk.x() + std::sin(angle_rad) * walk.y() < 0.0;
    directions_rad.push_back(backwards ? angle_rad + kPi : angle_rad);
  }
  return directions_rad;
}

}  // namespace

void DifferenceOfSlopeOptions::Validate() const {
  Require(window >= 2, "W is " + std::to_string(window) + ", must be at least 2");
  Require(gap >= 0, "M is " + std::to_string(gap) + ", must not be negative");
  Require(curve_width >= 1, "curve_width is " + std::to_string(curve_width) + ", must be positive");
  Require(zero_range_rad > 0.0 && zero_range_rad < corner_rad,
          "zero_range_rad is " + std::to_string(zero_range_rad) +
              ", must be positive and below corner_rad " + std::to_string(corner_rad));
  Require(concave_rad > 0.0,
          "concave_rad is " + std::to_string(concave_rad) + ", must be positive");
  Require(concave_width >= 0,
          "concave_width is " + std::to_string(concave_width) + ", must not be negative");
  Require(concave_noise_1 >= 0.0,
          "concave_noise_1 is " + std::to_string(concave_noise_1) + ", must not be negative");
}

ThetaPlot ComputeThetaPlot(std::span<const Eigen::Vector2d> curve_m,
                           const DifferenceOfSlopeOptions& options) {
  ThetaPlot plot;
  const size_t window = static_cast<size_t>(options.window);
  const size_t gap = static_cast<size_t>(options.gap);
  const size_t length = 2 * window + gap;
  plot.first = options.window + options.gap / 2;
  if (curve_m.size() < length) return plot;
  const std::vector<double> directions_rad = FittedDirections(curve_m, window);
  for (size_t i = 0; i + window + gap < directions_rad.size(); ++i) {
    plot.theta_rad.push_back(WrapAngle(directions_rad[i] - directions_rad[i + window + gap]));
  }
  return plot;
}

double ThetaNoise(double noise_m, double points_per_sample_1, double step_m,
                  const DifferenceOfSlopeOptions& options) {
  const double points = options.window * points_per_sample_1;
  const double length_m = options.window * step_m;
  if (!(points > 0.0 && length_m > 0.0)) return 0.0;
  return std::sqrt(2.0 * 12.0 / points) * noise_m / length_m;
}

CurveFeatures FindFeatures(const ThetaPlot& plot, const DifferenceOfSlopeOptions& options) {
  CurveFeatures features;
  const std::vector<double>& theta = plot.theta_rad;
  const double concave_rad =
      std::max(options.concave_rad, options.concave_noise_1 * plot.noise_rad);
  size_t i = 0;
  while (i < theta.size()) {
    const double sign = theta[i] < 0.0 ? -1.0 : 1.0;
    const size_t begin = i;
    double peak_rad = 0.0;
    while (i < theta.size() && sign * theta[i] > options.zero_range_rad) {
      peak_rad = std::max(peak_rad, sign * theta[i]);
      ++i;
    }
    if (i == begin) {  // within the zero-range
      ++i;
      continue;
    }
    if (sign < 0.0) {
      const bool sustained = static_cast<int>(i - begin) > options.concave_width;
      if (sustained && peak_rad > concave_rad) ++features.concavities;
      continue;
    }
    const bool wide = static_cast<int>(i - begin) > options.curve_width;
    const bool high = peak_rad > options.corner_rad;
    if (wide) ++features.curves;
    if (high) ++features.corners;
  }
  return features;
}

}  // namespace geon::recognition
