#include "rangefinder/range_profile.h"

#include <optional>

#include "base/contracts.h"

namespace geon::rangefinder {

sensor::RangeProfile MeasureProfile(const sensor::Stripe& stripe, const sensor::ScanPlan& plan,
                                    const LookUpTable& table, const geometry::SensorRig& rig,
                                    const PeakOptions& options) {
  Require(stripe.laser == table.laser, "MeasureProfile: the table is of the other laser");
  Require(stripe.difference.width_px == table.width_px &&
              stripe.difference.height_px == table.height_px,
          "MeasureProfile: the stripe's image has not the size of the table's");
  Require(
      stripe.stripe_index >= 0 && static_cast<size_t>(stripe.stripe_index) < plan.stripes.size(),
      "MeasureProfile: the plan has no stripe " + std::to_string(stripe.stripe_index));

  const geometry::RigidTransform X_RL = geometry::LevelFrame(
      rig.StripeCameraPose(plan.pan_rad, plan.tilt_rad), plan.support_height_m);
  const geometry::RigidTransform X_LR = X_RL.inverse();
  const geometry::RigidTransform X_LB =
      X_LR * rig.StripeCameraPose(stripe.pan_rad, stripe.tilt_rad);
  const bool horizontal = stripe.laser == sensor::Laser::kHorizontal;
  const geometry::LaserMount& laser = horizontal ? rig.horizontal_laser : rig.vertical_laser;

  sensor::RangeProfile profile;
  profile.utime = stripe.utime;
  profile.scan_id = stripe.scan_id;
  profile.attempt = stripe.attempt;
  profile.stripe_index = stripe.stripe_index;
  profile.laser = stripe.laser;
  profile.fraction = plan.stripes[static_cast<size_t>(stripe.stripe_index)].fraction;
  profile.rotation_LB = X_LB.linear();
  profile.laser_origin_L_m =
      X_LR * rig.HeadPose(stripe.pan_rad, stripe.tilt_rad) * laser.p_TLaser_m;
  for (const StripePeak& peak : FindStripePeaks(stripe.difference, stripe.laser, options)) {
    if (peak.reason != PeakReason::kFound) continue;
    const std::optional<double> distance_m = table.Distance(peak.pixel, peak.position_px);
    if (!distance_m) continue;
    const Eigen::Vector3d ray_B = horizontal ? rig.stripe_camera.Ray(peak.pixel, peak.position_px)
                                             : rig.stripe_camera.Ray(peak.position_px, peak.pixel);
    profile.pixel.push_back(peak.pixel);
    profile.p_L_m.push_back(X_LB * (*distance_m * ray_B));  // (3.10)
  }
  return profile;
}

}  // namespace geon::rangefinder
