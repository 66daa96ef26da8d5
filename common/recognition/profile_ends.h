#pragma once

#include <Eigen/Core>
#include <vector>

#include "sensor/scan_set.h"

namespace geon::recognition {

// The two end points of one stripe on the target, which lie on the geon's outline (section 5.4).
struct ProfileEnds {
  double fraction = 0.5;
  // Left and right (horizontal) or top and bottom (vertical). x right, y down, metres, seen from
  // the B/W camera at the scan's own attitude; see FindProfileEnds.
  Eigen::Vector2d first_m;
  Eigen::Vector2d last_m;
  double length_m = 0.0;  // of the stripe between its ends, along the stripe
};

// The ends of all horizontal (or vertical) profiles that have points, by rising fraction.
// `profiles` are background-free.
//
// The thesis compares x or y coordinates (5.3, 5.8). Here they are those of the perspective image,
// scaled by the mean distance of all end points to metres: a straight edge of a geon then stays a
// straight line whatever its direction in depth, which x and y in metres would not keep.
std::vector<ProfileEnds> FindProfileEnds(const std::vector<sensor::RangeProfile>& profiles,
                                         sensor::Laser laser, const Eigen::Vector3d& p_LB_m,
                                         const Eigen::Matrix3d& R_LB);

}  // namespace geon::recognition
