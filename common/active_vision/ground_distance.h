#pragma once

#include <Eigen/Core>
#include <optional>

#include "active_vision/head_angles.h"
#include "geometry/sensor_rig.h"

namespace geon::active_vision {

// The point of a target that stands on its support, nearest to the robot (point x of figure 4.9).
struct TargetFoot {
  Eigen::Vector3d p_R_m = Eigen::Vector3d::Zero();
  double distance_from_robot_m = 0.0;   // horizontal, from the robot's axis
  double distance_from_camera_m = 0.0;  // horizontal, from the B/W camera: ScanPlan::distance_m
  double bearing_rad = 0.0;             // of the foot in R, from straight ahead, left positive
};

// Where the ray through a pixel of the colour camera meets the horizontal plane that carries the
// target; nothing when it does not, looking at or above the horizon of that plane.
//
// Source: thesis 4.2.3, equations 4.28-4.29, derived from the rig's transforms: pitched mount, roll
// by panning, cameras off the axes, support height.
std::optional<TargetFoot> LocateTargetFoot(const geometry::SensorRig& rig, const HeadAngles& head,
                                           const Eigen::Vector2d& bottom_px,
                                           double support_height_m);

}  // namespace geon::active_vision
