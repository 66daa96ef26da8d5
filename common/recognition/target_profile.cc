#include "recognition/target_profile.h"

#include <algorithm>

#include "recognition/profile_noise.h"

namespace geon::recognition {
namespace {

// The points in `range`, smoothed.
std::vector<Eigen::Vector3d> SmoothedPoints(const sensor::RangeProfile& profile, PointRange range,
                                            std::span<const double> depth_m,
                                            const Eigen::Vector3d& p_LB_m,
                                            const SmoothingOptions& options) {
  const auto points_L_m = std::span(profile.p_L_m).subspan(range.begin, range.size());
  if (options.kind == Smoothing::kNone) return {points_L_m.begin(), points_L_m.end()};
  // What the windows reach at most.
  const size_t half = static_cast<size_t>(options.half_width_px);
  const size_t begin = range.begin - std::min(range.begin, half);
  const size_t count = std::min(range.end + half, depth_m.size()) - begin;
  const std::vector<double> smooth_m = SmoothDepths(std::span(profile.pixel).subspan(begin, count),
                                                    depth_m.subspan(begin, count), options);
  return MoveAlongRays(points_L_m, depth_m.subspan(range.begin, range.size()),
                       std::span(smooth_m).subspan(range.begin - begin, range.size()), p_LB_m);
}

}  // namespace

TargetProfile FindTargetProfile(const sensor::RangeProfile& profile, const sensor::ScanSet& scan,
                                const std::optional<VerticalRegion>& region,
                                const SmoothingOptions& smoothing,
                                const BackgroundOptions& background,
                                const SegmentOptions& segments) {
  TargetProfile target;
  target.laser = profile.laser;
  target.fraction = profile.fraction;
  target.rotation_LB = profile.rotation_LB.value_or(scan.rotation_LB);
  const Eigen::Vector3d& p_LB_m = scan.camera_position_L_m;
  const std::vector<double> depth_m = ProfileDepths(profile.p_L_m, p_LB_m, target.rotation_LB);
  target.noise_m = DepthNoise(profile.pixel, depth_m);
  const PointRange range = FindRegionRange(profile.p_L_m, scan, region);
  target.p_L_m = SmoothedPoints(profile, range, depth_m, p_LB_m, smoothing);
  DropBackground(scan, region, background, &target.p_L_m);
  target.segments = FindSegments(target.p_L_m, segments);
  return target;
}

}  // namespace geon::recognition
