#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/profile_curve.h"
#include "recognition/remove_background.h"
#include "sensor/scan_set.h"

namespace geon::recognition {

// What one stripe shows of the target, ready to be measured.
struct TargetStripe {
  sensor::Laser laser = sensor::Laser::kHorizontal;
  double fraction = 0.5;
  std::vector<Eigen::Vector3d> p_L_m;    // in the order of the pixels, spikes dropped
  std::vector<Eigen::Vector2d> curve_m;  // the same points as PlaneCurve gives them, smoothed
  // Where the parts that hang together begin in p_L_m and curve_m; never empty when they are not.
  std::vector<size_t> segment_begins;
  double noise_m = 0.0;  // of the depths, before smoothing
  bool empty() const { return p_L_m.empty(); }
  size_t SegmentEnd(size_t segment) const {
    return segment + 1 < segment_begins.size() ? segment_begins[segment + 1] : p_L_m.size();
  }
};

// The six stripes on the target: three horizontal, then three vertical, each by rising fraction.
// A stripe that the scan lacks, or that shows fewer than `segments.fewest_points` points of the
// target, is empty; of more than three stripes in a direction those nearest to 1/4, 1/2 and 3/4
// are taken.
//
// Source: thesis sections 5.1 and 5.4 for what is background and what a segment. Deviations: spikes
// are dropped, not replaced (a point further than `kSpike` sigmas of the profile's own noise from
// the median of five); the rest is averaged over a fiftieth of the stripe, where the thesis takes
// the median of a fixed window.
std::vector<TargetStripe> FindTargetStripes(const sensor::ScanSet& scan,
                                            const BackgroundOptions& background,
                                            const SegmentOptions& segments);

}  // namespace geon::recognition
