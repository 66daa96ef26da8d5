#pragma once

#include <Eigen/Core>
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
  float At(GridCell cell) const { return distance_m_[window_.Index(cell)]; }

 private:
  void Sweep(const OccupancyGrid& grid, int step);

  GridWindow window_;
  std::vector<Eigen::Vector2f> obstacles_W_m_;
  std::vector<int> nearest_;  // index of the obstacle, -1: none yet
  std::vector<float> distance_m_;
};

}  // namespace geon::navigation
