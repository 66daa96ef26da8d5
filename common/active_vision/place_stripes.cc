#include "active_vision/place_stripes.h"

#include <cmath>
#include <optional>

#include "active_vision/turn_head.h"
#include "base/contracts.h"

namespace geon::active_vision {
namespace {

using geometry::RigidTransform;

// Points of the target, in frame P: where rays of the colour camera meet the upright plane across
// the line of sight at the target's distance.
class TargetPlane {
 public:
  TargetPlane(const geometry::SensorRig& rig, const StripeTarget& target)
      : camera_(rig.color_camera), box_(target.box) {
    const RigidTransform X_PR = rig.X_RP.inverse();
    const RigidTransform X_RC = rig.ColorCameraPose(target.head.pan_rad, target.head.tilt_rad);
    const RigidTransform X_RB = rig.StripeCameraPose(target.head.pan_rad, target.head.tilt_rad);
    X_PC_ = X_PR * X_RC;
    Eigen::Vector3d across_R = X_RC.linear() * Ray(0.5, 0.5);
    across_R.z() = 0.0;
    across_R.normalize();
    normal_P_ = X_PR.linear() * across_R;
    offset_m_ = normal_P_.dot(X_PR * X_RB.translation()) + target.distance_m;
  }

  // The point at a fraction of the box from its left and from its top; nothing behind the camera.
  std::optional<Eigen::Vector3d> Point(double from_left_1, double from_top_1) const {
    const Eigen::Vector3d ray_P = X_PC_.linear() * Ray(from_left_1, from_top_1);
    const double along = (offset_m_ - normal_P_.dot(X_PC_.translation())) / normal_P_.dot(ray_P);
    if (!std::isfinite(along) || along <= 0.0) return std::nullopt;
    return X_PC_.translation() + along * ray_P;
  }

 private:
  Eigen::Vector3d Ray(double from_left_1, double from_top_1) const {
    return camera_.Ray(box_.u_px - 0.5 + from_left_1 * box_.w_px,
                       box_.v_px - 0.5 + from_top_1 * box_.h_px);
  }
  const geometry::PinholeCamera& camera_;
  sensor::PixelBox box_;
  RigidTransform X_PC_;
  Eigen::Vector3d normal_P_;
  double offset_m_ = 0.0;
};

// The B/W camera looks at the target's middle; each stripe then turns one axis away from that, as
// far as the limits let it.
HeadAngles Aim(const geometry::SensorRig& rig, const TargetPlane& plane, const HeadAngles& from,
               const HeadLimits& limits) {
  const std::optional<Eigen::Vector3d> p_PMiddle_m = plane.Point(0.5, 0.5);
  return limits.Clamp(p_PMiddle_m ? AimCamera(*p_PMiddle_m, rig.X_TB, from).value_or(from) : from);
}

std::optional<HeadAngles> TurnToFraction(const geometry::SensorRig& rig, const TargetPlane& plane,
                                         const HeadAngles& aimed, sensor::Laser laser,
                                         double fraction) {
  if (laser == sensor::Laser::kHorizontal) {
    const auto p_P_m = plane.Point(0.5, fraction);
    const geometry::LaserMount& mount = rig.horizontal_laser;
    return p_P_m ? TiltPlaneToPoint(*p_P_m, mount.p_TLaser_m, mount.normal_T, aimed) : std::nullopt;
  }
  const auto p_P_m = plane.Point(fraction, 0.5);
  const geometry::LaserMount& mount = rig.vertical_laser;
  return p_P_m ? PanPlaneToPoint(*p_P_m, mount.p_TLaser_m, mount.normal_T, aimed) : std::nullopt;
}

void RequireTarget(const StripeTarget& target) {
  Require(target.box.w_px > 0 && target.box.h_px > 0, "PlaceStripes: the box is empty");
  Require(std::isfinite(target.distance_m) && target.distance_m > 0.0,
          "PlaceStripes: distance_m must be positive");
}

}  // namespace

StripePlacement PlaceStripes(const geometry::SensorRig& rig, const StripeTarget& target,
                             const HeadLimits& limits, const StripePlacementOptions& options) {
  RequireTarget(target);
  const TargetPlane plane(rig, target);
  const HeadAngles aimed = Aim(rig, plane, target.head, limits);
  StripePlacement placement;
  for (const sensor::Laser laser : {sensor::Laser::kHorizontal, sensor::Laser::kVertical}) {
    for (const double fraction : options.fractions_1) {
      const auto head = TurnToFraction(rig, plane, aimed, laser, fraction);
      const HeadAngles nearest = limits.Clamp(head.value_or(aimed));
      const bool reached = head && limits.Contain(*head);
      (reached ? placement.stripes : placement.unreachable)
          .push_back({laser, fraction, nearest.pan_rad, nearest.tilt_rad});
    }
  }
  return placement;
}

std::optional<HeadAngles> PlaceStripe(const geometry::SensorRig& rig, const StripeTarget& target,
                                      const HeadLimits& limits, sensor::Laser laser,
                                      double fraction) {
  RequireTarget(target);
  const TargetPlane plane(rig, target);
  const auto head =
      TurnToFraction(rig, plane, Aim(rig, plane, target.head, limits), laser, fraction);
  if (!head || !limits.Contain(*head)) return std::nullopt;
  return head;
}

}  // namespace geon::active_vision
