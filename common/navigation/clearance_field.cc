#include "navigation/clearance_field.h"

#include <limits>

#include "base/contracts.h"

namespace geon::navigation {

void ClearanceField::Compute(const OccupancyGrid& grid, const GridWindow& window,
                             const std::function<bool(const Eigen::Vector2d&)>& ignored) {
  Require(window.width() > 0 && window.height() > 0, "ClearanceField: the window is empty");
  window_ = window;
  constexpr float kNowhere_m = std::numeric_limits<float>::infinity();
  nearest_.assign(window.size(), {kNowhere_m, kNowhere_m, kNowhere_m});
  bool any = false;
  grid.VisitObstacles(window, [&](GridCell cell, const Eigen::Vector2d& p_W_m) {
    if (ignored && ignored(p_W_m)) return;
    nearest_[window.Index(cell)] = {static_cast<float>(p_W_m.x()), static_cast<float>(p_W_m.y()),
                                    static_cast<float>((p_W_m - grid.Middle(cell)).squaredNorm())};
    any = true;
  });
  if (!any) return;
  middle_x_W_m_.clear();
  for (int x = window.first.x; x <= window.last.x; ++x) {
    middle_x_W_m_.push_back(static_cast<float>(grid.Middle({x, 0}).x()));
  }
  Sweep(grid, 1);
  Sweep(grid, -1);
}

// Row by row: from the row before, then along the row in both directions.
void ClearanceField::Sweep(const OccupancyGrid& grid, int step) {
  const auto width = static_cast<size_t>(window_.width());
  const Nearest* before = nullptr;
  for (int row = 0; row < window_.height(); ++row) {
    const int y = step > 0 ? window_.first.y + row : window_.last.y - row;
    const auto y_W_m = static_cast<float>(grid.Middle({0, y}).y());
    Nearest* const cells = &nearest_[window_.Index({window_.first.x, y})];
    const auto take = [&](size_t column, const Nearest& other) {
      const float dx_m = other.x_W_m - middle_x_W_m_[column];
      const float dy_m = other.y_W_m - y_W_m;
      const float squared_m2 = dx_m * dx_m + dy_m * dy_m;
      if (squared_m2 < cells[column].squared_m2) {
        cells[column] = {other.x_W_m, other.y_W_m, squared_m2};
      }
    };
    for (size_t k = 0; before != nullptr && k < width; ++k) {
      if (k > 0) take(k, before[k - 1]);
      take(k, before[k]);
      if (k + 1 < width) take(k, before[k + 1]);
    }
    for (size_t k = 1; k < width; ++k) take(k, cells[k - 1]);
    for (size_t k = width - 1; k > 0; --k) take(k - 1, cells[k]);
    before = cells;
  }
}

}  // namespace geon::navigation
