#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "recognition/target_profile.h"

namespace geon::recognition {

// Source: thesis sections 5.4 and 5.5, figures 5.12 and 5.15.
//
// The two end points of one stripe on the target, which lie on the geon's outline (section 5.4), in
// the axes of the B/W camera at the scan's own attitude: x right, y down, z forward, metres.
struct ProfileEnds {
  double fraction = 0.5;
  Eigen::Vector3d first_B_m;  // left (horizontal stripe) or top (vertical)
  Eigen::Vector3d last_B_m;   // right or bottom
  double length_m = 0.0;      // of the stripe between them: along x, or along y
};

// The ends of all horizontal (or vertical) profiles that show the target, by rising fraction.
//
// Lengths are taken across the image, like the distances of figure 5.15: a length in space would
// grow where a stripe runs in depth.
std::vector<ProfileEnds> FindProfileEnds(std::span<const TargetProfile> profiles,
                                         sensor::Laser laser, const BwCamera& camera);

}  // namespace geon::recognition
