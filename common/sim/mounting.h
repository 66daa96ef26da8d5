#pragma once

#include "geometry/sensor_rig.h"
#include "sim/camera_options.h"
#include "sim/lens.h"

namespace geon::sim {

// A straight line in space, about which something turns.
struct TurnAxis {
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit

  geometry::RigidTransform Turn(double angle_rad) const;
};

// A line laser: a fan of light about `forward` in the plane across `normal`, but for a bow: at the
// edge of the fan (options.fan_half_angle) the line is off the plane by bow_1 times the distance
// forward, growing with the square of the tangent of the angle from the middle.
struct BuiltLaser {
  Eigen::Vector3d p_TLaser_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_T = Eigen::Vector3d::UnitZ();   // unit
  Eigen::Vector3d forward_T = Eigen::Vector3d::UnitX();  // unit, across the normal
  double bow_1 = 0.0;
};

// One robot of the series, as it was really built. Frames: R, P, T, C, B, F of docs/frames.md. T is
// the drawing's: where the head is when the unit's true angles are both 0.
struct BuiltRig {
  BuiltCamera color_camera, stripe_camera, floor_camera;
  geometry::RigidTransform X_RP = geometry::RigidTransform::Identity();
  geometry::RigidTransform X_TC = geometry::RigidTransform::Identity();
  geometry::RigidTransform X_TB = geometry::RigidTransform::Identity();
  geometry::RigidTransform X_RF = geometry::RigidTransform::Identity();
  TurnAxis pan_P;   // turning left is positive
  TurnAxis tilt_P;  // at pan 0; turning about it lowers the head: a tilt counts up
  // True angles when the unit counts 0.
  double pan_zero_rad = 0.0;
  double tilt_zero_rad = 0.0;
  BuiltLaser horizontal_laser, vertical_laser;

  // X_RT when the unit counts (pan, tilt).
  geometry::RigidTransform HeadPose(double pan_rad, double tilt_rad) const {
    return X_RP * pan_P.Turn(pan_rad + pan_zero_rad) * tilt_P.Turn(-tilt_rad - tilt_zero_rad);
  }
  geometry::RigidTransform ColorCameraPose(double pan_rad, double tilt_rad) const {
    return HeadPose(pan_rad, tilt_rad) * X_TC;
  }
  geometry::RigidTransform StripeCameraPose(double pan_rad, double tilt_rad) const {
    return HeadPose(pan_rad, tilt_rad) * X_TB;
  }
};

// The individual built from a drawing: everything is off by a little. These errors are why the
// rangefinder must be calibrated (thesis section 3.2). Of the drawing's lenses and axes (which say
// what somebody calibrated) nothing is taken over.
BuiltRig AsBuilt(const geometry::SensorRig& designed, const MountingErrorOptions& options);

}  // namespace geon::sim
