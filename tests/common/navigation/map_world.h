#pragma once

#include <Eigen/Core>
#include <cmath>
#include <span>
#include <vector>

#include "navigation/occupancy_grid.h"

namespace geon::navigation {

// A wall from a to b, as many points.
inline std::vector<Eigen::Vector2d> Wall(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m,
                                         double spacing_m = 0.02) {
  const int count = static_cast<int>(std::ceil((b_m - a_m).norm() / spacing_m));
  std::vector<Eigen::Vector2d> points_m;
  for (int i = 0; i <= count; ++i) {
    points_m.emplace_back(a_m + (b_m - a_m) * (static_cast<double>(i) / count));
  }
  return points_m;
}

inline void Append(const std::vector<Eigen::Vector2d>& more_m,
                   std::vector<Eigen::Vector2d>* points_m) {
  points_m->insert(points_m->end(), more_m.begin(), more_m.end());
}

// Walls along a line that comes back to its first corner.
inline std::vector<Eigen::Vector2d> ClosedWall(std::span<const Eigen::Vector2d> corners_m) {
  std::vector<Eigen::Vector2d> points_m;
  for (size_t i = 0; i < corners_m.size(); ++i) {
    Append(Wall(corners_m[i], corners_m[(i + 1) % corners_m.size()]), &points_m);
  }
  return points_m;
}

// Makes obstacles exactly there: felt, so that one time is enough.
inline void Put(std::span<const Eigen::Vector2d> points_W_m, OccupancyGrid* grid) {
  grid->Feel(0.0, geometry::RigidTransform::Identity(), points_W_m);
}

// The floor camera has seen bare floor in every cell of the square of this half side.
inline void SeeAllFloor(double half_m, OccupancyGrid* grid) {
  const double cell_m = grid->cell_m();
  const double margin_m = OccupancyGridOptions().floor_margin_m;
  const std::vector<FloorColumn> ahead = {{{0.0, 0.0}, {1.0 + margin_m, 0.0}, false}};
  for (double y_m = -half_m + 0.5 * cell_m; y_m < half_m; y_m += cell_m) {
    for (double x_m = -half_m; x_m < half_m; x_m += 1.0) {
      grid->SeeFloor(0.0, geometry::PlanarPose(x_m, y_m, 0.0), ahead);
    }
  }
}

// The square of this half side.
inline GridWindow WindowAround(double half_m, const OccupancyGrid& grid) {
  const int half = static_cast<int>(std::lround(half_m / grid.cell_m()));
  return {{-half, -half}, {half - 1, half - 1}};
}

template <typename Visit>
void ForEachCell(const GridWindow& window, Visit visit) {
  for (int y = window.first.y; y <= window.last.y; ++y) {
    for (int x = window.first.x; x <= window.last.x; ++x) visit(GridCell{x, y});
  }
}

}  // namespace geon::navigation
