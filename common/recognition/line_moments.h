#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace geon::recognition {

// How points spread about a centre: sums of squares and products.
struct Scatter {
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

// Sums over a run of points; the difference of two gives the run between them, so that lines can be
// fitted to all runs of a curve in one pass.
//
// Source: Duda and Hart 1973, section 9.2: the best line minimises the perpendicular distances.
struct LineMoments {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

  LineMoments operator-(const LineMoments& other) const {
    return {n - other.n, x - other.x, y - other.y, xx - other.xx, xy - other.xy, yy - other.yy};
  }
  void Add(const Eigen::Vector2d& p) {
    n += 1.0;
    x += p.x();
    y += p.y();
    xx += p.x() * p.x();
    xy += p.x() * p.y();
    yy += p.y() * p.y();
  }
  // Sums of squares and products about the mean.
  Scatter AboutMean() const {
    const double share = 1.0 / n;
    return {xx - share * x * x, xy - share * x * y, yy - share * y * y};
  }
  // Sum of squared distances from the best line (the scatter's smaller eigenvalue).
  double LineResidual() const {
    if (n < 1.0) return 0.0;
    const auto [a, b, c] = AboutMean();
    return std::max(0.0, 0.5 * (a + c - std::sqrt((a - c) * (a - c) + 4.0 * b * b)));
  }
};

// The moments of the first 0, 1, ... n points, taken from the first.
inline std::vector<LineMoments> RunningMoments(std::span<const Eigen::Vector2d> points) {
  std::vector<LineMoments> until;
  until.reserve(points.size() + 1);
  LineMoments sums;
  until.push_back(sums);
  for (const Eigen::Vector2d& p : points) {
    sums.Add(p - points.front());
    until.push_back(sums);
  }
  return until;
}

}  // namespace geon::recognition
