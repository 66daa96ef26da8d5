#include "navigation/waypoint.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::navigation {
namespace {

constexpr double kWorthMoving_m = 0.08;

// The farthest place of the cheapest way that lies in the polygon.
Eigen::Vector2d FarthestOnWay(const geometry::ConvexPolygon& polygon,
                              const geometry::RigidTransform& X_WR, const OccupancyGrid& grid,
                              const CostToGo& cost) {
  const geometry::RigidTransform X_RW = X_WR.inverse();
  Eigen::Vector2d farthest_R_m = Eigen::Vector2d::Zero();
  // No longer than any way that could come back into the polygon.
  constexpr int kMostCells = 160;
  std::optional<GridCell> cell = grid.CellAt(X_WR.translation().head<2>());
  for (int i = 0; i < kMostCells; ++i) {
    cell = cost.Next(*cell);
    if (!cell) break;
    const Eigen::Vector2d p_R_m = geometry::OnGround(X_RW, grid.Middle(*cell));
    if (polygon.Contains(p_R_m)) farthest_R_m = p_R_m;
  }
  return farthest_R_m;
}

}  // namespace

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

std::optional<Eigen::Vector2d> WaypointByCost(const geometry::ConvexPolygon& polygon,
                                              const geometry::RigidTransform& X_WR,
                                              const OccupancyGrid& grid, const CostToGo& cost) {
  const Eigen::Vector2d farthest_R_m = FarthestOnWay(polygon, X_WR, grid, cost);
  constexpr double kAtAll_m = 0.01;
  if (farthest_R_m.norm() >= kAtAll_m) return farthest_R_m;
  constexpr double kSpacing_m = 0.1;
  const double here_m = cost.At(grid.CellAt(X_WR.translation().head<2>()));
  std::optional<Eigen::Vector2d> best_R_m;
  double best_cost_m = here_m - kWorthMoving_m;
  const auto vertices = polygon.vertices();
  for (size_t i = 0; i < vertices.size(); ++i) {
    const Eigen::Vector2d edge_m = vertices[(i + 1) % vertices.size()] - vertices[i];
    const int samples = std::max(1, static_cast<int>(std::ceil(edge_m.norm() / kSpacing_m)));
    for (int k = 0; k < samples; ++k) {
      const Eigen::Vector2d p_R_m = vertices[i] + edge_m * (static_cast<double>(k) / samples);
      if (p_R_m.norm() < kWorthMoving_m) continue;
      const double cost_m = cost.At(grid.CellAt(geometry::OnGround(X_WR, p_R_m)));
      if (cost_m >= best_cost_m) continue;
      best_cost_m = cost_m;
      best_R_m = p_R_m;
    }
  }
  return best_R_m;
}

}  // namespace geon::navigation
