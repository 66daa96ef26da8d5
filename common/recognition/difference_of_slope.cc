#include "recognition/difference_of_slope.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"
#include "recognition/line_moments.h"

namespace geon::recognition {
namespace {

// Direction, of any length, of the total-least-squares line through points: twice its angle is that
// of (xx - yy, 2 xy), which is halved without an angle.
Eigen::Vector2d LineDirection(const Scatter& scatter) {
  const double cosine = scatter.xx - scatter.yy, sine = 2.0 * scatter.xy;
  const double length = std::sqrt(cosine * cosine + sine * sine);
  if (length == 0.0) return Eigen::Vector2d::UnitX();
  return cosine >= 0.0 ? Eigen::Vector2d(length + cosine, sine)
                       : Eigen::Vector2d(std::abs(sine), std::copysign(length - cosine, sine));
}

// Direction of the line through each `window` successive points, along the walk.
std::vector<Eigen::Vector2d> FittedDirections(std::span<const Eigen::Vector2d> curve_m,
                                              size_t window) {
  const std::vector<LineMoments> until = RunningMoments(curve_m);
  std::vector<Eigen::Vector2d> directions(curve_m.size() + 1 - window);
  for (size_t begin = 0; begin < directions.size(); ++begin) {
    const Eigen::Vector2d line = LineDirection((until[begin + window] - until[begin]).AboutMean());
    const Eigen::Vector2d walk = curve_m[begin + window - 1] - curve_m[begin];
    directions[begin] = line.dot(walk) < 0.0 ? Eigen::Vector2d(-line) : line;
  }
  return directions;
}

// By how much the walk turns clockwise from direction a to direction b.
double ClockwiseTurn(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double cross = a.y() * b.x() - a.x() * b.y(), dot = a.dot(b);
  return dot > std::abs(cross) ? std::atan(cross / dot) : std::atan2(cross, dot);
}

}  // namespace

void DifferenceOfSlopeOptions::Validate() const {
  Require(window >= 2, "W", window, "must be at least 2");
  Require(gap >= 0, "M", gap, "must not be negative");
  Require(curve_width >= 1, "curve_width", curve_width, "must be positive");
  Require(zero_range_rad > 0.0 && zero_range_rad < corner_rad, "zero_range_rad", zero_range_rad,
          "must be positive and below corner_rad");
  Require(concave_rad > 0.0, "concave_rad", concave_rad, "must be positive");
  Require(concave_width >= 0, "concave_width", concave_width, "must not be negative");
  Require(concave_noise_1 >= 0.0, "concave_noise_1", concave_noise_1, "must not be negative");
}

ThetaPlot ComputeThetaPlot(std::span<const Eigen::Vector2d> curve_m,
                           const DifferenceOfSlopeOptions& options) {
  ThetaPlot plot;
  const size_t window = static_cast<size_t>(options.window);
  const size_t gap = static_cast<size_t>(options.gap);
  const size_t length = 2 * window + gap;
  plot.first = options.window + options.gap / 2;
  if (curve_m.size() < length) return plot;
  const std::vector<Eigen::Vector2d> directions = FittedDirections(curve_m, window);
  plot.theta_rad.resize(curve_m.size() + 1 - length);
  for (size_t i = 0; i < plot.theta_rad.size(); ++i) {
    plot.theta_rad[i] = ClockwiseTurn(directions[i], directions[i + window + gap]);
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
