#include "navigation/safe_polygon.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::navigation {

namespace {

// Farthest point that can still cut the box.
double Vicinity(const SafePolygonOptions& options) {
  return std::numbers::sqrt2 * options.default_box_m + options.clearance_m;
}

}  // namespace

bool SafePolygonOptions::IsValid(std::string* error) const {
  const auto fail = [&](const std::string& rule) {
    if (error != nullptr) *error = rule;
    return false;
  };
  if (!(clearance_m > 0.0)) return fail("clearance_m must be positive");
  if (!(default_box_m > 0.0)) return fail("default_box_m must be positive");
  if (!(slack_m > 0.0 && slack_m < clearance_m)) {
    return fail("slack_m must lie between 0 and clearance_m");
  }
  // Two obstacles' directions differ by at least this angle, which bounds the number of lines.
  const double apart_rad = std::acos(1.0 - slack_m / Vicinity(*this));
  if (2.0 * kPi / apart_rad + 4.0 >= geometry::ConvexPolygon::kMaxVertices) {
    return fail("slack_m is too small for default_box_m: more lines than the polygon can hold");
  }
  return true;
}

geometry::ConvexPolygon SafePolygon(std::span<Eigen::Vector2d> obstacles_R_m,
                                    const SafePolygonOptions& options) {
  std::string error;
  Require(options.IsValid(&error), error);

  geometry::ConvexPolygon polygon =
      geometry::ConvexPolygon::Box(options.default_box_m, options.default_box_m);

  // A point on the robot's axis has no direction; such a point is a sensor's error.
  constexpr double kOnAxis_m = 1e-3;
  const double vicinity_m = Vicinity(options);
  auto rest = std::partition(obstacles_R_m.begin(), obstacles_R_m.end(), [&](const auto& p_m) {
    const double distance_m = p_m.norm();
    return distance_m > kOnAxis_m && distance_m < vicinity_m;
  });
  const auto nearer = [](const auto& a_m, const auto& b_m) {
    return a_m.squaredNorm() < b_m.squaredNorm();
  };
  for (auto begin = obstacles_R_m.begin(); begin != rest;) {
    const Eigen::Vector2d nearest_m = *std::min_element(begin, rest, nearer);
    const double distance_m = nearest_m.norm();
    const Eigen::Vector2d normal = nearest_m / distance_m;
    polygon.Clip({normal, std::max(0.0, distance_m - options.clearance_m)});
    // Of an obstacle that is too near the line goes through the robot: what it keeps away is less.
    const double behind_m = std::max(distance_m, options.clearance_m) - options.slack_m;
    rest = std::partition(begin, rest, [&](const auto& p_m) {
      return p_m != nearest_m && normal.dot(p_m) < behind_m;
    });
  }
  return polygon;
}

}  // namespace geon::navigation
