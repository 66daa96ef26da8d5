#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/profile_curve.h"
#include "recognition/region_profile.h"
#include "recognition/remove_background.h"
#include "recognition/smooth_profile.h"

namespace geon::recognition {

// What one profile shows of the target: smoothed, without background, split where it does not hang
// together.
struct TargetProfile {
  sensor::Laser laser = sensor::Laser::kHorizontal;
  double fraction = 0.5;
  Eigen::Matrix3d R_LB;                // of the B/W camera at this stripe
  double noise_m = 0.0;                // of the depths, before smoothing
  std::vector<Eigen::Vector3d> p_L_m;  // in the order of the pixels
  std::vector<PointRange> segments;    // of p_L_m; points in none are stray

  // The end points of the stripe on the target; only where it has segments.
  const Eigen::Vector3d& first_L() const { return p_L_m[segments.front().begin]; }
  const Eigen::Vector3d& last_L() const { return p_L_m[segments.back().end - 1]; }
};

// Source: thesis sections 5.1 (smoothing, background removal) and 5.4 (segments, figure 5.10).
// `on_target`: a label for each point of `part` (label_points.h); empty: the thesis's test of the
// smoothed point against `background.floor_margin_m`.
TargetProfile FindTargetProfile(const RegionProfile& part, const SmoothingOptions& smoothing,
                                const BackgroundOptions& background, const SegmentOptions& segments,
                                const std::vector<bool>& on_target = {});

}  // namespace geon::recognition
