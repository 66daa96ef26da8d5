#pragma once

#include <vector>

#include "active_vision/head_angles.h"
#include "geometry/pinhole_camera.h"

namespace geon::active_vision {

// The area to look at, in head angles relative to the pan-tilt unit's own axes.
struct SearchOptions {
  double pan_min_rad = -0.70;  // 40 degrees to the right ...
  double pan_max_rad = 0.70;   // ... and to the left: "roughly facing the geon"
  double tilt_min_rad = -0.82;
  double tilt_max_rad = 0.10;
  // Shares of the view that neighbouring looks have in common.
  double pan_overlap_1 = 0.25;
  double tilt_overlap_1 = 0.25;
};

// Looks that together cover the area: rows from the bottom up (a geon stands on the floor, close
// by), every row from the side where the last one ended, the first row starting at the side nearer
// to `start`. Looks stay within the limits; what the limits keep out of sight stays unseen.
//
// Source: thesis 4.2.2 ("moving the camera with the PTU to cover a large area"). The pattern is
// ours.
std::vector<HeadAngles> SearchPattern(const geometry::PinholeCamera& camera,
                                      const HeadLimits& limits, const HeadAngles& start,
                                      const SearchOptions& options = {});

// How far beside a look of the pattern a picture may be taken and still show all that this look is
// there for: half of what it has in common with its neighbours. With half the view in common, a
// head that pans by less than that from picture to picture misses nothing and need not stop.
HeadAngles LookTolerance(const geometry::PinholeCamera& camera, const SearchOptions& options);

}  // namespace geon::active_vision
