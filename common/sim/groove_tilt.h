#pragma once

#include <Eigen/Core>

#include "sim/world.h"

namespace geon::sim {

// How the floor tilts the robot: one or more of its three wheels stand in a groove between tiles
// (thesis section 6.3). `base_rad` is the direction of the first wheel's leg, which never turns.
// Identity on a floor without tilt.
Eigen::Matrix3d GrooveTilt(const World& world, const Eigen::Vector2d& center_W_m, double base_rad);

}  // namespace geon::sim
