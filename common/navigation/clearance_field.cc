#include "navigation/clearance_field.h"

#include <limits>

#include "base/contracts.h"

namespace geon::navigation {

void ClearanceField::Compute(const OccupancyGrid& grid, const GridWindow& window,
                             const std::function<bool(const Eigen::Vector2d&)>& ignored) {
  Require(window.width() > 0 && window.height() > 0, "ClearanceField: the window is empty");
  window_ = window;
  obstacles_W_m_.clear();
  nearest_.assign(window.size(), -1);
  distance_m_.assign(window.size(), std::numeric_limits<float>::infinity());
  size_t index = 0;
  for (int y = window.first.y; y <= window.last.y; ++y) {
    for (int x = window.first.x; x <= window.last.x; ++x, ++index) {
      const auto obstacle_W_m = grid.ObstacleIn({x, y});
      if (!obstacle_W_m || (ignored && ignored(*obstacle_W_m))) continue;
      nearest_[index] = static_cast<int>(obstacles_W_m_.size());
      obstacles_W_m_.push_back(obstacle_W_m->cast<float>());
      distance_m_[index] = static_cast<float>((*obstacle_W_m - grid.Middle({x, y})).norm());
    }
  }
  if (obstacles_W_m_.empty()) return;
  Sweep(grid, 1);
  Sweep(grid, -1);
}

// Row by row: from the row before, then along the row in both directions.
void ClearanceField::Sweep(const OccupancyGrid& grid, int step) {
  const auto take = [&](GridCell cell, int dx, int dy) {
    const GridCell from{cell.x + dx, cell.y + dy};
    if (!window_.Contains(from)) return;
    const int nearest = nearest_[window_.Index(from)];
    const size_t index = window_.Index(cell);
    if (nearest < 0 || nearest == nearest_[index]) return;
    const float distance_m =
        (obstacles_W_m_[static_cast<size_t>(nearest)] - grid.Middle(cell).cast<float>()).norm();
    if (distance_m >= distance_m_[index]) return;
    distance_m_[index] = distance_m;
    nearest_[index] = nearest;
  };
  for (int row = 0; row < window_.height(); ++row) {
    const int y = step > 0 ? window_.first.y + row : window_.last.y - row;
    for (int x = window_.first.x; x <= window_.last.x; ++x) {
      for (int dx = -1; dx <= 1; ++dx) take({x, y}, dx, -step);
    }
    for (int x = window_.first.x; x <= window_.last.x; ++x) take({x, y}, -1, 0);
    for (int x = window_.last.x; x >= window_.first.x; --x) take({x, y}, 1, 0);
  }
}

}  // namespace geon::navigation
