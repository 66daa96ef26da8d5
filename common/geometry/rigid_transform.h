#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace geon::geometry {

// X_AB takes coordinates in frame B to coordinates in frame A: p_A = X_AB * p_B. The frames'
// letters are those of docs/frames.md (O odometry, W pen floor, R robot, P PTU base, T PTU head, C
// colour camera, B B/W camera, F floor camera, L level frame of a scan).
using RigidTransform = Eigen::Isometry3d;

inline RigidTransform MakeTransform(const Eigen::Matrix3d& R_AB, const Eigen::Vector3d& p_AB) {
  RigidTransform X_AB = RigidTransform::Identity();
  X_AB.linear() = R_AB;
  X_AB.translation() = p_AB;
  return X_AB;
}

inline Eigen::Matrix3d RotationAboutX(double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitX()).toRotationMatrix();
}
inline Eigen::Matrix3d RotationAboutY(double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
}
inline Eigen::Matrix3d RotationAboutZ(double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

// The rotation R_AB of a camera (x right, y down, z forward) whose optical axis is the x axis of a
// body frame A (x forward, y left, z up).
inline Eigen::Matrix3d CameraAxesInBody() {
  Eigen::Matrix3d R_AB;
  R_AB << 0, 0, 1,  //
      -1, 0, 0,     //
      0, -1, 0;
  return R_AB;
}

// Where the robot stands on the pen floor: X_WR (metres, radians, heading counter-clockwise from
// the x axis of W).
inline RigidTransform PlanarPose(double x_m, double y_m, double heading_rad) {
  return MakeTransform(RotationAboutZ(heading_rad), Eigen::Vector3d(x_m, y_m, 0.0));
}

// The heading of such a pose, -pi to pi.
inline double HeadingOf(const RigidTransform& X_WR) {
  return std::atan2(X_WR.linear()(1, 0), X_WR.linear()(0, 0));
}

// Takes the place (x, y) on the ground of B to A, where both have the ground at z = 0.
inline Eigen::Vector2d OnGround(const RigidTransform& X_AB, const Eigen::Vector2d& p_B_m) {
  return (X_AB * Eigen::Vector3d(p_B_m.x(), p_B_m.y(), 0.0)).head<2>();
}

}  // namespace geon::geometry
