#pragma once

#include <Eigen/Core>

#include "base/angles.h"
#include "geometry/rigid_transform.h"

namespace geon::sim {

// Where the turret and its rings are at one instant.
struct RingPose {
  Eigen::Vector2d center_W_m = Eigen::Vector2d::Zero();  // on the floor
  double bearing_W_rad = 0.0;                            // of sensor 0
  // How the floor tilts the robot, about the centre (sim/groove_tilt.h).
  Eigen::Matrix3d rotation_W = Eigen::Matrix3d::Identity();
};

// X_WS of sensor `index` of `count` on a ring: x along its axis, outward, z up.
inline geometry::RigidTransform RingSensorPose(const RingPose& pose, int index, int count,
                                               double radius_m, double height_m) {
  const Eigen::Matrix3d R_WS =
      pose.rotation_W * geometry::RotationAboutZ(pose.bearing_W_rad + index * 2.0 * kPi / count);
  return geometry::MakeTransform(R_WS,
                                 Eigen::Vector3d(pose.center_W_m.x(), pose.center_W_m.y(), 0.0) +
                                     R_WS * Eigen::Vector3d(radius_m, 0.0, height_m));
}

}  // namespace geon::sim
