#pragma once

#include <Eigen/Core>

namespace geon::sim {

// A floor of square tiles; W's axes lie in grooves between them.
struct FloorGrooves {
  double tile_m = 0.6;
  double tilt_rad = 0.0;  // of the robot with one wheel in a groove
};

// How the floor tilts the robot: one or more of its three wheels stand in a groove between tiles
// (thesis section 6.3). `base_rad` is the direction of the first wheel's leg, which never turns.
// Identity on a floor without tilt.
Eigen::Matrix3d GrooveTilt(const FloorGrooves& grooves, const Eigen::Vector2d& center_W_m,
                           double base_rad);

}  // namespace geon::sim
