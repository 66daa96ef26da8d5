#include "rangefinder/range_profile.h"

#include "base/contracts.h"

namespace geon::rangefinder {
namespace {

using geometry::RigidTransform;

const geometry::LaserMount& LaserOf(const sensor::Stripe& stripe, const geometry::SensorRig& rig) {
  return stripe.laser == sensor::Laser::kHorizontal ? rig.horizontal_laser : rig.vertical_laser;
}

// A profile with a point for each peak to which `distance_m(peak, ray_B)`, the ray having z = 1,
// gives a distance along the optical axis.
template <typename Distance>
sensor::RangeProfile ProfileOf(const sensor::Stripe& stripe, const sensor::ScanPlan& plan,
                               const geometry::SensorRig& rig, const PeakOptions& options,
                               Distance distance_m) {
  Require(
      stripe.stripe_index >= 0 && static_cast<size_t>(stripe.stripe_index) < plan.stripes.size(),
      "RangeProfile: the plan has no stripe " + std::to_string(stripe.stripe_index));
  const RigidTransform X_RL = geometry::LevelFrame(
      rig.StripeCameraPose(plan.pan_rad, plan.tilt_rad), plan.support_height_m);
  const RigidTransform X_LT = X_RL.inverse() * rig.HeadPose(stripe.pan_rad, stripe.tilt_rad);
  const RigidTransform X_LB = X_LT * rig.X_TB;
  const bool horizontal = stripe.laser == sensor::Laser::kHorizontal;

  sensor::RangeProfile profile;
  profile.utime = stripe.utime;
  profile.scan_id = stripe.scan_id;
  profile.attempt = stripe.attempt;
  profile.stripe_index = stripe.stripe_index;
  profile.laser = stripe.laser;
  profile.fraction = plan.stripes[static_cast<size_t>(stripe.stripe_index)].fraction;
  profile.rotation_LB = X_LB.linear();
  profile.laser_origin_L_m = X_LT * LaserOf(stripe, rig).p_TLaser_m;
  for (const StripePeak& peak : FindStripePeaks(stripe.difference, stripe.laser, options)) {
    if (peak.reason != PeakReason::kFound) continue;
    const Eigen::Vector3d ray_B = horizontal ? rig.stripe_camera.Ray(peak.pixel, peak.position_px)
                                             : rig.stripe_camera.Ray(peak.position_px, peak.pixel);
    const std::optional<double> z_m = distance_m(peak, ray_B);
    if (!z_m) continue;
    profile.pixel.push_back(peak.pixel);
    profile.p_L_m.push_back(X_LB * (*z_m * ray_B));  // (3.10)
  }
  return profile;
}

}  // namespace

sensor::RangeProfile MeasureProfile(const sensor::Stripe& stripe, const sensor::ScanPlan& plan,
                                    const LookUpTable& table, const geometry::SensorRig& rig,
                                    const PeakOptions& options) {
  Require(stripe.laser == table.laser, "MeasureProfile: the table is of the other laser");
  Require(stripe.difference.width_px == table.width_px &&
              stripe.difference.height_px == table.height_px,
          "MeasureProfile: the stripe's image has not the size of the table's");
  return ProfileOf(stripe, plan, rig, options,
                   [&](const StripePeak& peak, const Eigen::Vector3d& /*ray_B*/) {
                     return table.Distance(peak.pixel, peak.position_px);
                   });
}

std::optional<std::string> TriangulationOptions::Validate() const {
  if (nearest_m > 0.0 && nearest_m < farthest_m) return std::nullopt;
  return "nearest_m must be above 0 and below farthest_m";
}

sensor::RangeProfile TriangulateStripe(const sensor::Stripe& stripe, const sensor::ScanPlan& plan,
                                       const geometry::SensorRig& rig, const PeakOptions& options,
                                       const TriangulationOptions& triangulation) {
  const std::optional<std::string> problem = triangulation.Validate();
  Require(!problem, "TriangulateStripe: " + problem.value_or(""));
  Require(stripe.difference.width_px == rig.stripe_camera.width_px &&
              stripe.difference.height_px == rig.stripe_camera.height_px,
          "TriangulateStripe: the stripe's image has not the size of the rig's B/W camera");
  const geometry::LaserMount& laser = LaserOf(stripe, rig);
  return ProfileOf(
      stripe, plan, rig, options,
      [&](const StripePeak& /*peak*/, const Eigen::Vector3d& ray_B) -> std::optional<double> {
        const double z_m = rig.DistanceToFan(laser, ray_B);
        if (!(z_m >= triangulation.nearest_m && z_m <= triangulation.farthest_m)) {
          return std::nullopt;
        }
        return z_m;
      });
}

}  // namespace geon::rangefinder
