#include "active_vision/ground_distance.h"

#include <cmath>

namespace geon::active_vision {

std::optional<TargetFoot> LocateTargetFoot(const geometry::SensorRig& rig, const HeadAngles& head,
                                           const Eigen::Vector2d& bottom_px,
                                           double support_height_m) {
  const geometry::RigidTransform X_RC = rig.ColorCameraPose(head.pan_rad, head.tilt_rad);
  const Eigen::Vector3d ray_R = X_RC.linear() * rig.color_camera.Ray(bottom_px.x(), bottom_px.y());
  const Eigen::Vector3d p_RC_m = X_RC.translation();
  const double drop_m = p_RC_m.z() - support_height_m;
  if (drop_m <= 0.0 || ray_R.z() >= 0.0) return std::nullopt;

  TargetFoot foot;
  foot.p_R_m = p_RC_m + ray_R * (drop_m / -ray_R.z());
  const Eigen::Vector3d p_RB_m = rig.StripeCameraPose(head.pan_rad, head.tilt_rad).translation();
  foot.distance_from_robot_m = foot.p_R_m.head<2>().norm();
  foot.distance_from_camera_m = (foot.p_R_m - p_RB_m).head<2>().norm();
  foot.bearing_rad = std::atan2(foot.p_R_m.y(), foot.p_R_m.x());
  return foot;
}

}  // namespace geon::active_vision
