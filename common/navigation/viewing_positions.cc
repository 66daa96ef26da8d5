#include "navigation/viewing_positions.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"

namespace geon::navigation {
namespace {

bool IsHidden(const OccupancyGrid& grid, const Eigen::Vector2d& from_W_m,
              const Eigen::Vector2d& target_W_m, double own_m) {
  const Eigen::Vector2d along_m = target_W_m - from_W_m;
  const int steps = static_cast<int>(std::ceil((along_m.norm() - own_m) / grid.cell_m()));
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector2d p_W_m = from_W_m + along_m.normalized() * (i * grid.cell_m());
    const auto obstacle_W_m = grid.ObstacleIn(grid.CellAt(p_W_m));
    if (obstacle_W_m && (*obstacle_W_m - target_W_m).norm() > own_m) return true;
  }
  return false;
}

}  // namespace

std::vector<CostToGo::Goal> ViewingPositions(const OccupancyGrid& grid,
                                             const ClearanceField& clearance,
                                             const Eigen::Vector2d& target_W_m, double own_m,
                                             const ViewingOptions& options) {
  std::vector<CostToGo::Goal> goals;
  const Eigen::Vector2d reach_m(options.distance_m, options.distance_m);
  const GridCell low = grid.CellAt(target_W_m - reach_m);
  const GridCell high = grid.CellAt(target_W_m + reach_m);
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const Eigen::Vector2d place_W_m = grid.Middle({x, y});
      const double distance_m = (place_W_m - target_W_m).norm();
      if (distance_m > options.distance_m || distance_m < options.distance_m - options.nearer_m ||
          !clearance.window().Contains({x, y})) {
        continue;
      }
      const Eigen::Vector2d out_m = place_W_m - target_W_m;
      if (options.side_rad && std::abs(WrapAngle(std::atan2(out_m.y(), out_m.x()) -
                                                 *options.side_rad)) > options.side_tolerance_rad) {
        continue;
      }
      const bool hidden = IsHidden(grid, place_W_m, target_W_m, own_m);
      goals.push_back({{x, y}, hidden ? options.hidden_cost_m : 0.0});
    }
  }
  return goals;
}

}  // namespace geon::navigation
