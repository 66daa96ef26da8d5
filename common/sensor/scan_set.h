#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/geon_label.h"
#include "sensor/image.h"
#include "sensor/stripe.h"

namespace geon::sensor {

// What became of the stripe that a profile answers.
enum class ProfileStatus {
  kOk = 0,
  kMissing = 1,  // no laser light on the target
  kRefused = 2,  // the stripe camera could not deliver it
};

// What one laser stripe measured, in the level frame L (x forward, y left, z up, z = 0 on the floor
// or table that carries the object, origin below the B/W camera), before background removal.
struct RangeProfile {
  int64_t utime = 0;
  int32_t seq = 0;
  int64_t scan_id = 0;
  int32_t stripe_index = 0;
  int32_t attempt = 0;  // of the scan command answered
  ProfileStatus status = ProfileStatus::kOk;
  int32_t on_target = 0;  // points left after background removal
  Laser laser = Laser::kHorizontal;
  // Where the stripe was meant to lie, or a swept one lies: from the top (horizontal) or the left
  // (vertical) of the target.
  double fraction = 0.5;
  // Image column (horizontal stripe) or row (vertical) of each point, strictly increasing; a
  // missing pixel is a gap (no return, or occluded).
  std::vector<int> pixel;
  std::vector<Eigen::Vector3d> p_L_m;  // same size as pixel
  // How likely the target's colour is where each point lies, 0..1; empty: not known.
  std::vector<double> on_color_1;
  // Rotation of the B/W camera at this stripe; the scan's own when absent.
  std::optional<Eigen::Matrix3d> rotation_LB;
  std::optional<Eigen::Vector3d> laser_origin_L_m;
};

// The profiles of one scan: contract geon.scan_set.v1 (docs/channels.md has the file format).
struct ScanSet {
  int64_t scan_id = 0;
  Eigen::Vector3d camera_position_L_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation_LB = Eigen::Matrix3d::Identity();
  std::optional<PixelBox> target_box;  // in the colour image, where the target was measured
  std::vector<RangeProfile> profiles;
  std::optional<GeonLabel> truth;  // evaluation only; recognition never looks at it
};

// One stripe to be laid: the head's angles that put it at `fraction` of the target.
struct PlannedStripe {
  Laser laser = Laser::kHorizontal;
  double fraction = 0.5;
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
};

// What the planner is about to scan and all the recognizer needs to make sense of the stripes.
struct ScanPlan {
  int64_t utime = 0;
  int32_t seq = 0;
  int64_t scan_id = 0;
  PixelBox target_box;   // in the colour image taken at (pan_rad, tilt_rad)
  double pan_rad = 0.0;  // head when the box was measured: defines the level frame L
  double tilt_rad = 0.0;
  double support_height_m = 0.0;  // of the plane that carries the target
  double distance_m = 0.0;        // horizontal, from the B/W camera to the target's foot
  std::vector<PlannedStripe> stripes;
};

// How far beside its planned stripe a profile lies, as a part of the target. Its `stripe_index`
// must be one of the plan's.
inline double Misplacement(const ScanPlan& plan, const RangeProfile& profile) {
  return std::abs(profile.fraction -
                  plan.stripes[static_cast<size_t>(profile.stripe_index)].fraction);
}

}  // namespace geon::sensor
