#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "navigation/clearance_field.h"

namespace geon::navigation {

struct CostToGoOptions {
  // The robot's axis never comes nearer to an obstacle: body 0.267 m and what sensors and odometry
  // are off by. Larger: narrow gaps count as closed.
  double least_clearance_m = 0.29;
  // Nearer than this a metre costs more, at the least clearance `crowding_1` metres more.
  double easy_clearance_m = 0.50;
  double crowding_1 = 2.0;
  double unseen_1 = 0.3;  // what a metre of floor that no picture showed costs more

  std::optional<std::string> Validate() const;
};

// What it costs to drive from each cell of a window to the nearest of some goals: metres, longer
// near obstacles.
//
// Source: wavefront (Barraquand and Latombe 1991) in Dijkstra's order over eight neighbours; path
// lengths on the grid are up to 8 % above the straight ones.
// Unknown cells count as free: the map learns better on the way. From cells nearer to an obstacle
// than the least clearance costs lead out to where there is room, never through a wall; out of a
// gap that is too narrow, to either side. At an obstacle itself (one and a half cells) nothing
// leads on.
class CostToGo {
 public:
  struct Goal {
    GridCell cell;
    double cost_m = 0.0;  // at the goal
  };

  explicit CostToGo(const CostToGoOptions& options);

  // Goals off the window or too near to an obstacle count for nothing.
  void Compute(const OccupancyGrid& grid, const ClearanceField& clearance,
               std::span<const Goal> goals);

  // Infinite where no way leads to a goal, and off the window.
  double At(GridCell cell) const;
  // The neighbour to go on to; nothing at a goal, and where no way leads.
  std::optional<GridCell> Next(GridCell cell) const;
  const GridWindow& window() const { return window_; }

 private:
  struct Cell {
    float cost_m;
    float per_metre_1;  // what a metre to here from a neighbour costs; infinite: none leads here
    uint8_t next;       // which neighbour
    bool tight;         // nearer to an obstacle than the least clearance
  };
  void Weigh(const OccupancyGrid& grid, const ClearanceField& clearance);

  CostToGoOptions options_;
  GridWindow window_;
  GridWindow framed_;  // the window with a frame of cells that nothing leads to
  std::vector<Cell> cells_;
  std::vector<std::vector<uint32_t>> buckets_;  // of cells, by cost
};

}  // namespace geon::navigation
