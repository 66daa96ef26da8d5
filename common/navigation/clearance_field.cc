#include "navigation/clearance_field.h"

#include <limits>

#include "base/contracts.h"

namespace geon::navigation {

void ClearanceField::Compute(const OccupancyGrid& grid, const GridWindow& window,
                             const std::function<bool(const Eigen::Vector2d&)>& ignored) {
  Require(window.width() > 0 && window.height() > 0, "ClearanceField: the window is empty");
  window_ = window;
  const auto cells = static_cast<size_t>(window.width()) * static_cast<size_t>(window.height());
  obstacles_W_m_.clear();
  nearest_.assign(cells, -1);
  distance_m_.assign(cells, std::numeric_limits<float>::infinity());
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
  const int width = window_.width();
  const int height = window_.height();
  const auto take = [&](int x, int y, int from_x, int from_y) {
    if (from_x < 0 || from_x >= width || from_y < 0 || from_y >= height) return;
    const int nearest = nearest_[static_cast<size_t>(from_y) * static_cast<size_t>(width) +
                                 static_cast<size_t>(from_x)];
    if (nearest < 0) return;
    const size_t index =
        static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    if (nearest == nearest_[index]) return;
    const Eigen::Vector2d middle_W_m = grid.Middle({window_.first.x + x, window_.first.y + y});
    const float distance_m =
        (obstacles_W_m_[static_cast<size_t>(nearest)] - middle_W_m.cast<float>()).norm();
    if (distance_m >= distance_m_[index]) return;
    distance_m_[index] = distance_m;
    nearest_[index] = nearest;
  };
  for (int row = 0; row < height; ++row) {
    const int y = step > 0 ? row : height - 1 - row;
    for (int x = 0; x < width; ++x) {
      for (int dx = -1; dx <= 1; ++dx) take(x, y, x + dx, y - step);
    }
    for (int x = 1; x < width; ++x) take(x, y, x - 1, y);
    for (int x = width - 2; x >= 0; --x) take(x, y, x + 1, y);
  }
}

}  // namespace geon::navigation
