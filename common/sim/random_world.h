#pragma once

#include <cstdint>

#include "sim/world.h"

namespace geon::sim {

enum class GeonPlace { kFloor, kBox, kAny };

// A random trial of thesis section 6.3: a pen with one geon of random shape and pose on the floor
// or on a box of 70 cm, up to two boxes more, and a robot at least 1.5 m away that can drive to it.
// The same seed gives the same world.
World RandomWorld(uint64_t seed, GeonPlace place);

// The same with several geons (at most 4), at least 1.1 m from each other, each of which the robot
// can drive to; two may be of one shape.
World RandomWorldOfSeveral(uint64_t seed, GeonPlace place, int geons);

// Whether a robot at the world's start can drive, `clearance_m` away from everything, to a place
// from `nearest_m` to `farthest_m` away from (x, y).
bool CanReach(const World& world, const Eigen::Vector2d& goal_m, double nearest_m,
              double farthest_m, double clearance_m);

}  // namespace geon::sim
