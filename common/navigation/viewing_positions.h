#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "navigation/clearance_field.h"
#include "navigation/cost_to_go.h"

namespace geon::navigation {

struct ViewingOptions {
  double distance_m = 0.93;    // from the robot's axis to the target's foot, at most
  double nearer_m = 0.10;      // and at most this much nearer
  double hidden_cost_m = 0.6;  // driven farther for a place whose view is not cut by an obstacle
  // Only from this side: bearing in W from the target to the robot, and how far beside it.
  std::optional<double> side_rad;
  double side_tolerance_rad = 0.20;
};

// Source: thesis section 4.3 for the distance; the set is ours.
//
// The cells of the clearance's window from which a target can be looked at and measured, as goals
// of CostToGo: about `distance_m` away, "approx. 90 cm" in the thesis (4.3); those behind an
// obstacle, which may be lower than the line of sight, as second choice. Obstacles within `own_m`
// of the target are its own: itself, its desk.
std::vector<CostToGo::Goal> ViewingPositions(const OccupancyGrid& grid,
                                             const ClearanceField& clearance,
                                             const Eigen::Vector2d& target_W_m, double own_m,
                                             const ViewingOptions& options);

}  // namespace geon::navigation
