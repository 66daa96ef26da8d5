#pragma once

#include <cmath>

#include "geometry/pinhole_camera.h"
#include "geometry/rigid_transform.h"

namespace geon::geometry {

// A line laser: a fan of light in the plane { p : normal . (p - origin) = 0 }, seen from T.
struct LaserMount {
  Eigen::Vector3d p_TLaser_m = Eigen::Vector3d::Zero();  // where the fan starts, frame T
  Eigen::Vector3d normal_T = Eigen::Vector3d::UnitZ();   // unit normal of the fan's plane, frame T
};

// How a pan-tilt unit is built: pan turns about the z axis of P; the tilt axis, carried by pan, is
// the y axis of T turned by two small angles and shifted. All 0: the axes are square and meet.
struct PtuAxes {
  double tilt_roll_rad = 0.0;                           // of the tilt axis, about x of T
  double tilt_yaw_rad = 0.0;                            // of the tilt axis, about z of T
  Eigen::Vector3d p_PTilt_m = Eigen::Vector3d::Zero();  // a point of the tilt axis at pan = 0
};

// The head of the robot and the camera that watches the floor, as mounted (thesis
// figures 3.2, 3.10; figures in scripts/config/robot.yaml).
//
// P sits on the turret, T is carried by the pan-tilt unit, both with x forward, y left, z up; the
// cameras have x right, y down, z forward. Positive pan turns left, positive tilt looks up.
struct SensorRig {
  PinholeCamera color_camera;
  PinholeCamera stripe_camera;
  PinholeCamera floor_camera{320, 240, 160.0, 160.0, 159.5, 119.5};
  RigidTransform X_RP = RigidTransform::Identity();
  PtuAxes ptu_axes;
  RigidTransform X_TC = RigidTransform::Identity();
  RigidTransform X_TB = RigidTransform::Identity();
  RigidTransform X_RF = RigidTransform::Identity();
  LaserMount horizontal_laser;
  LaserMount vertical_laser;

  // X_RT of the head turned to (pan, tilt).
  RigidTransform HeadPose(double pan_rad, double tilt_rad) const {
    const Eigen::Matrix3d lean =
        RotationAboutZ(ptu_axes.tilt_yaw_rad) * RotationAboutX(ptu_axes.tilt_roll_rad);
    const Eigen::Matrix3d R_PanT = lean * RotationAboutY(-tilt_rad) * lean.transpose();
    const Eigen::Matrix3d R_PPan = RotationAboutZ(pan_rad);
    return X_RP * MakeTransform(R_PPan * R_PanT,
                                R_PPan * (ptu_axes.p_PTilt_m - R_PanT * ptu_axes.p_PTilt_m));
  }
  RigidTransform ColorCameraPose(double pan_rad, double tilt_rad) const {
    return HeadPose(pan_rad, tilt_rad) * X_TC;
  }
  RigidTransform StripeCameraPose(double pan_rad, double tilt_rad) const {
    return HeadPose(pan_rad, tilt_rad) * X_TB;
  }
  // Where a ray of the B/W camera (its frame, z = 1) meets a laser's fan: the distance along the
  // optical axis. Negative behind the camera, not finite where the two run side by side.
  double DistanceToFan(const LaserMount& laser, const Eigen::Vector3d& ray_B) const {
    const Eigen::Vector3d normal_B = X_TB.linear().transpose() * laser.normal_T;
    return laser.normal_T.dot(laser.p_TLaser_m - X_TB.translation()) / normal_B.dot(ray_B);
  }
};

// X_RL of the level frame of a scan, given the pose of the B/W camera at which the target was
// measured: origin on the plane z = 0 below the camera's centre, x along the horizontal part of the
// optical axis, z up. `support_height_m` lifts the plane z = 0 of L to the table that carries the
// target (0 for the floor).
inline RigidTransform LevelFrame(const RigidTransform& X_RB, double support_height_m) {
  const Eigen::Vector3d axis_R = X_RB.linear().col(2);
  const double heading_rad = std::atan2(axis_R.y(), axis_R.x());
  const Eigen::Vector3d p_RB = X_RB.translation();
  return MakeTransform(RotationAboutZ(heading_rad),
                       Eigen::Vector3d(p_RB.x(), p_RB.y(), support_height_m));
}

// X_CL: takes points of the level frame of a scan into the colour camera, as both stood when the
// target was measured.
inline RigidTransform ColorFromLevel(const SensorRig& rig, double pan_rad, double tilt_rad,
                                     double support_height_m) {
  return rig.ColorCameraPose(pan_rad, tilt_rad).inverse() *
         LevelFrame(rig.StripeCameraPose(pan_rad, tilt_rad), support_height_m);
}

}  // namespace geon::geometry
