#pragma once

#include "geometry/rigid_transform.h"
#include "sensor/scan_set.h"

namespace geon::recognition {

// A camera one metre up that looks along x, and a horizontal stripe on a wall two metres away: from
// y = `first_y_m` to the right, a pixel every `step_m`.
inline sensor::ScanSet WallScan(int points, double first_y_m, double step_m) {
  sensor::ScanSet scan;
  scan.camera_position_L_m = {0.0, 0.0, 1.0};
  scan.rotation_LB = geometry::CameraAxesInBody();
  sensor::RangeProfile profile;
  profile.laser = sensor::Laser::kHorizontal;
  for (int i = 0; i < points; ++i) {
    profile.pixel.push_back(i);
    profile.p_L_m.emplace_back(2.0, first_y_m - step_m * i, 0.8);
  }
  scan.profiles.push_back(profile);
  return scan;
}

}  // namespace geon::recognition
