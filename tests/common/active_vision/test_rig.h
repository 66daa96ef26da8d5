#pragma once

#include "base/angles.h"
#include "geometry/sensor_rig.h"

namespace geon::active_vision {

// A head like that of scripts/config/robot.yaml: cameras above one another, lasers 125 mm from the
// B/W camera's axis, which their planes cross at `crosses_axis_m`.
inline geometry::SensorRig TestRig(double pitch_down_rad = RadiansFromDegrees(15.0),
                                   double crosses_axis_m = 1.037) {
  constexpr double kBaseline_m = 0.125;
  geometry::SensorRig rig;
  rig.X_RP = geometry::MakeTransform(geometry::RotationAboutY(pitch_down_rad), {0.0, 0.0, 1.2});
  rig.X_TC = geometry::MakeTransform(geometry::CameraAxesInBody(), {0.05, 0.0, 0.110});
  rig.X_TB = geometry::MakeTransform(geometry::CameraAxesInBody(), {0.05, 0.0, 0.045});
  rig.horizontal_laser.p_TLaser_m = {0.05, 0.0, 0.045 + kBaseline_m};
  rig.horizontal_laser.normal_T = Eigen::Vector3d(kBaseline_m, 0.0, crosses_axis_m).normalized();
  rig.vertical_laser.p_TLaser_m = {0.05, kBaseline_m, 0.045};
  rig.vertical_laser.normal_T = Eigen::Vector3d(kBaseline_m, crosses_axis_m, 0.0).normalized();
  return rig;
}

}  // namespace geon::active_vision
