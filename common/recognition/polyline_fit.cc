#include "recognition/polyline_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::recognition {
namespace {

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double DistanceFromChord(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                         const Eigen::Vector2d& b) {
  const Eigen::Vector2d chord = b - a;
  const double length = chord.norm();
  return length > 0.0 ? std::abs(Cross(chord, p - a)) / length : (p - a).norm();
}

// Of the turns with one sign that follow each other without a long piece or a straight vertex in
// between.
struct Run {
  size_t begin = 0;
  size_t end = 0;
};

}  // namespace

void PolylineOptions::Validate() const {
  Require(tolerance_m > 0.0, "polyline tolerance_m", tolerance_m, "must be positive");
  Require(straight_rad > 0.0 && straight_rad < corner_rad, "straight_rad", straight_rad,
          "must be positive and below corner_rad");
  Require(curve_step_1 > 0.0, "curve_step_1", curve_step_1, "must be positive");
  Require(concave_rad > 0.0, "concave_rad", concave_rad, "must be positive");
}

std::vector<int> RamerVertices(std::span<const Eigen::Vector2d> curve_m, double tolerance_m) {
  Require(curve_m.size() >= 2, "a curve needs at least 2 points");
  const int last = static_cast<int>(curve_m.size()) - 1;
  std::vector<int> vertices = {0, last};
  std::vector<std::pair<int, int>> open = {{0, last}};
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    int farthest = begin;
    double distance_m = tolerance_m;
    for (int i = begin + 1; i < end; ++i) {
      const double d_m =
          DistanceFromChord(curve_m[static_cast<size_t>(i)], curve_m[static_cast<size_t>(begin)],
                            curve_m[static_cast<size_t>(end)]);
      if (d_m <= distance_m) continue;
      distance_m = d_m;
      farthest = i;
    }
    if (farthest == begin) continue;
    vertices.push_back(farthest);
    open.emplace_back(begin, farthest);
    open.emplace_back(farthest, end);
  }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

std::vector<int> WallVertices(std::span<const Eigen::Vector2d> curve_m, double tolerance_m) {
  Require(curve_m.size() >= 2, "a curve needs at least 2 points");
  std::vector<int> vertices = {0};
  size_t start = 0;
  double doubled_area_m2 = 0.0;
  for (size_t i = 1; i < curve_m.size(); ++i) {
    const Eigen::Vector2d to_previous = curve_m[i - 1] - curve_m[start];
    const Eigen::Vector2d to_current = curve_m[i] - curve_m[start];
    doubled_area_m2 += Cross(to_previous, to_current);
    if (std::abs(doubled_area_m2) <= tolerance_m * to_current.norm() || i - 1 == start) continue;
    start = i - 1;  // the last point that was still within tolerance
    vertices.push_back(static_cast<int>(start));
    doubled_area_m2 = 0.0;
  }
  vertices.push_back(static_cast<int>(curve_m.size()) - 1);
  return vertices;
}

std::vector<double> VertexTurns(std::span<const Eigen::Vector2d> curve_m,
                                std::span<const int> vertices) {
  std::vector<double> turn_rad;
  for (size_t k = 1; k + 1 < vertices.size(); ++k) {
    const Eigen::Vector2d& a = curve_m[static_cast<size_t>(vertices[k - 1])];
    const Eigen::Vector2d& b = curve_m[static_cast<size_t>(vertices[k])];
    const Eigen::Vector2d& c = curve_m[static_cast<size_t>(vertices[k + 1])];
    const Eigen::Vector2d before = b - a;
    const Eigen::Vector2d after = c - b;
    turn_rad.push_back(-std::atan2(Cross(before, after), before.dot(after)));
  }
  return turn_rad;
}

CurveFeatures FindFeatures(std::span<const Eigen::Vector2d> curve_m, std::span<const int> vertices,
                           const PolylineOptions& options) {
  CurveFeatures features;
  const std::vector<double> turn_rad = VertexTurns(curve_m, vertices);
  double total_m = 0.0;
  std::vector<double> piece_m;
  for (size_t k = 0; k + 1 < vertices.size(); ++k) {
    piece_m.push_back(
        (curve_m[static_cast<size_t>(vertices[k + 1])] - curve_m[static_cast<size_t>(vertices[k])])
            .norm());
    total_m += piece_m.back();
  }
  size_t k = 0;
  while (k < turn_rad.size()) {
    if (turn_rad[k] < -options.concave_rad) ++features.concavities;
    if (turn_rad[k] <= options.straight_rad) {
      ++k;
      continue;
    }
    Run run{k, k + 1};  // piece_m[j] lies between the turns j - 1 and j
    while (run.end < turn_rad.size() && turn_rad[run.end] > options.straight_rad &&
           piece_m[run.end] < options.curve_step_1 * total_m) {
      ++run.end;
    }
    if (run.end - run.begin >= 2) {
      ++features.curves;
    } else if (turn_rad[k] > options.corner_rad) {
      ++features.corners;
    }
    k = run.end;
  }
  return features;
}

}  // namespace geon::recognition
