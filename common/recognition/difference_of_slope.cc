#include "recognition/difference_of_slope.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::recognition {
namespace {

// Direction of the total-least-squares line through the points, along the walk.
double FittedDirection(std::span<const Eigen::Vector2d> points_m) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : points_m) mean += p;
  mean /= static_cast<double>(points_m.size());
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const Eigen::Vector2d& p : points_m) {
    const Eigen::Vector2d d = p - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double angle_rad = 0.5 * std::atan2(2.0 * xy, xx - yy);
  const Eigen::Vector2d walk = points_m.back() - points_m.front();
  const bool backwards = std::cos(angle_rad) * walk.x() + std::sin(angle_rad) * walk.y() < 0.0;
  return backwards ? angle_rad + kPi : angle_rad;
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
}

ThetaPlot ComputeThetaPlot(std::span<const Eigen::Vector2d> curve_m,
                           const DifferenceOfSlopeOptions& options) {
  ThetaPlot plot;
  const size_t window = static_cast<size_t>(options.window);
  const size_t gap = static_cast<size_t>(options.gap);
  const size_t length = 2 * window + gap;
  plot.first = options.window + options.gap / 2;
  if (curve_m.size() < length) return plot;
  for (size_t begin = 0; begin + length <= curve_m.size(); ++begin) {
    const double before_rad = FittedDirection(curve_m.subspan(begin, window));
    const double after_rad = FittedDirection(curve_m.subspan(begin + window + gap, window));
    plot.theta_rad.push_back(WrapAngle(before_rad - after_rad));
  }
  return plot;
}

CurveFeatures FindFeatures(const ThetaPlot& plot, const DifferenceOfSlopeOptions& options) {
  CurveFeatures features;
  const std::vector<double>& theta = plot.theta_rad;
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
      if (peak_rad > options.concave_rad) ++features.concavities;
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
