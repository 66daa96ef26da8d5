#pragma once

#include <vector>

#include "active_vision/head_angles.h"
#include "sensor/scan_set.h"

namespace geon::active_vision {

// How fast the head turns (defaults: PTU-46-17.5).
struct HeadMotion {
  double speed_rad_s = 0.897;         // 51.4 degrees/s
  double acceleration_rad_s2 = 1.79;  // 103 degrees/s^2
};

// Seconds from standing at one look to standing at the other, both axes turning at once.
double TurnTime(const HeadAngles& from, const HeadAngles& to, const HeadMotion& motion = {});

// The order in which to lay stripes so that the head turns for the shortest time, starting from a
// look: indices into `stripes`. All horizontal ones come first: what they measure tells how far the
// surface is that the vertical ones are to cut, whose laser sits farther aside. At most three of
// each laser.
//
// Source: ours; thesis 4.2.4 lays them in the order it computes them.
std::vector<size_t> OrderStripes(const std::vector<sensor::PlannedStripe>& stripes,
                                 const HeadAngles& from, const HeadMotion& motion = {});

}  // namespace geon::active_vision
