#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "recognition/bw_camera.h"
#include "recognition/label_points.h"
#include "recognition/profile_curve.h"
#include "recognition/region_profile.h"
#include "recognition/remove_background.h"
#include "sensor/scan_set.h"

namespace geon::recognition {

// What one stripe shows of the target, ready to be measured.
struct TargetStripe {
  sensor::Laser laser = sensor::Laser::kHorizontal;
  double fraction = 0.5;
  std::vector<Eigen::Vector3d> p_L_m;        // in the order of the pixels, spikes dropped
  std::vector<Eigen::Vector2d> curve_m;      // the same points as PlaneCurve gives them, smoothed
  std::vector<Eigen::Vector2d> tangent_B_1;  // ... and their x/z and y/z in the B/W camera
  // Where the parts that hang together begin in them; never empty when they are not.
  std::vector<size_t> segment_begins;
  double noise_m = 0.0;  // of the depths, before smoothing
  bool empty() const { return p_L_m.empty(); }
  size_t SegmentEnd(size_t segment) const {
    return segment + 1 < segment_begins.size() ? segment_begins[segment + 1] : p_L_m.size();
  }
};

// The target as a scan shows it; frame L stands level on the target's support (support_plane.h).
struct TargetView {
  // Three horizontal, then three vertical, each by rising fraction. A stripe that the scan lacks,
  // or that shows fewer than `segments.fewest_points` points of the target, is empty; of more than
  // three stripes in a direction those nearest to 1/4, 1/2 and 3/4 are taken.
  std::vector<TargetStripe> stripes;
  BwCamera camera;  // at the target
};

// Source: thesis sections 5.1 and 5.4 for what is background and what a segment. Deviations:
// - what is background is told by `labels`, whose support the target is levelled on;
// - the horizontal stripes, whose places in the target box are known, also tell the rows between
//   which the target lies: what vertical stripes show far beyond them is background;
// - spikes are dropped, not replaced (a point further than five sigmas of the profile's own noise
//   from the median of five), and so are the ends that a profile draws out along the viewing rays
//   where a camera mixes the target's edge with what is behind it;
// - the rest is averaged over a fiftieth of the stripe, where the thesis takes the median of a
//   fixed window.
//
// `region` as from FindVerticalRegion, `profiles` as from FindRegionProfiles, `labels` as from
// LabelPoints, all of the same scan.
TargetView FindTargetView(const sensor::ScanSet& scan, const std::optional<VerticalRegion>& region,
                          std::span<const RegionProfile> profiles, const ScanLabels& labels,
                          const BackgroundOptions& background, const SegmentOptions& segments);

}  // namespace geon::recognition
