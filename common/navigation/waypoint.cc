#include "navigation/waypoint.h"

#include <algorithm>

#include "base/contracts.h"

namespace geon::navigation {

Eigen::Vector2d WaypointToTarget(const geometry::ConvexPolygon& polygon,
                                 const Eigen::Vector2d& target_R_m, double stop_distance_m) {
  Require(!polygon.empty(), "WaypointToTarget: the safe polygon is empty");
  const double distance_m = target_R_m.norm();
  if (distance_m <= stop_distance_m) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d stop_R_m = target_R_m * (1.0 - stop_distance_m / distance_m);
  if (polygon.Contains(stop_R_m)) return stop_R_m;
  const auto vertices = polygon.vertices();
  return *std::min_element(vertices.begin(), vertices.end(), [&](const auto& a_m, const auto& b_m) {
    return (a_m - target_R_m).squaredNorm() < (b_m - target_R_m).squaredNorm();
  });
}

std::optional<Eigen::Vector2d> WanderWaypoint(const geometry::ConvexPolygon& polygon,
                                              double min_move_m, std::mt19937& random) {
  const auto far_enough = [&](const Eigen::Vector2d& v_m) { return v_m.norm() >= min_move_m; };
  const auto vertices = polygon.vertices();
  const auto count = std::count_if(vertices.begin(), vertices.end(), far_enough);
  if (count == 0) return std::nullopt;
  // A plain remainder instead of a distribution: the same seed gives the same walk with every
  // library.
  auto skip = static_cast<long>(random() % static_cast<unsigned long>(count));
  for (const Eigen::Vector2d& vertex_m : vertices) {
    if (far_enough(vertex_m) && skip-- == 0) return vertex_m;
  }
  return std::nullopt;
}

}  // namespace geon::navigation
