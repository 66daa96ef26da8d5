#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <vector>

#include "navigation/occupancy_grid.h"

namespace geon::navigation {

// How far the middle of every cell of a window is from the nearest obstacle.
//
// Source: Danielsson, "Euclidean distance mapping" (1980), in its 8-neighbour form: two sweeps in
// which every cell takes over its neighbours' nearest obstacle when that is nearer than its own.
// Deviation: distances are to where in its cell an obstacle was met. Off by a few hundredths of a
// cell in rare arrangements, never short of the true nearest by more.
class ClearanceField {
 public:
  // Obstacles for which `ignored` holds (places in W) do not count; an empty function ignores none.
  void Compute(const OccupancyGrid& grid, const GridWindow& window,
               const std::function<bool(const Eigen::Vector2d&)>& ignored = {});

  const GridWindow& window() const { return window_; }
  // Infinite where there is no obstacle at all; the cell must be in the window.
  float At(GridCell cell) const { return std::sqrt(nearest_[window_.Index(cell)].squared_m2); }

 private:
  // The obstacle that a cell knows to be nearest, and its distance's square; at first none.
  struct Nearest {
    float x_W_m, y_W_m, squared_m2;
  };
  void Sweep(const OccupancyGrid& grid, int step);

  GridWindow window_;
  std::vector<Nearest> nearest_;
  std::vector<float> middle_x_W_m_;  // of the columns
};

}  // namespace geon::navigation
