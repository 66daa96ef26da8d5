#pragma once

#include <vector>

#include "base/status.h"
#include "calibration/rig_observations.h"
#include "geometry/sensor_rig.h"

namespace geon::calibration {

struct FloorOptions {
  int min_points = 200;
  double min_spread_m = 0.2;  // of the points, across and along: less holds no plane
  double noise_m = 0.002;     // of a floor point's height; what is off by more counts less
};

// Where the head stands over the floor.
struct FloorFit {
  // X_RP with the height, roll and pitch that the floor gives it; its x, y and yaw, which a floor
  // cannot tell, are those of the rig.
  geometry::RigidTransform X_RP = geometry::RigidTransform::Identity();
  // What had to change for it, from the rig's X_RP: forward and leftward lean of the floor, and how
  // much higher P is.
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
  double height_m = 0.0;
  double rms_m = 0.0;  // of the points about the plane
  int points = 0;
};

// A plane through what the horizontal laser met on a flat floor, as the rig measures it: robust to
// skirting boards and grooves by Cauchy weights. Errors: too few points, or all on one line.
Result<FloorFit> FitFloor(const std::vector<FloorView>& views, const geometry::SensorRig& rig,
                          const FloorOptions& options = {});

// The same from points in R.
Result<FloorFit> FitFloorPoints(const std::vector<Eigen::Vector3d>& p_R_m,
                                const geometry::SensorRig& rig, const FloorOptions& options = {});

}  // namespace geon::calibration
