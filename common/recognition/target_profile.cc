#include "recognition/target_profile.h"

namespace geon::recognition {

TargetProfile FindTargetProfile(const RegionProfile& part, const SmoothingOptions& smoothing,
                                const BackgroundOptions& background, const SegmentOptions& segments,
                                const std::vector<bool>& on_target) {
  TargetProfile target;
  target.laser = part.laser;
  target.fraction = part.fraction;
  target.R_LB = part.camera.R_LB;
  target.noise_m = part.noise_m;
  const std::vector<double> smooth_m = SmoothDepths(part.pixel, part.depth_m, smoothing);
  const Eigen::Vector3d& p_LB_m = part.camera.p_LB_m;
  target.p_L_m.resize(smooth_m.size());
  size_t kept = 0;
  for (size_t i = 0; i < smooth_m.size(); ++i) {  // each along its own viewing ray (3.10)
    const Eigen::Vector3d moved_L_m =
        p_LB_m + (part.p_L_m[i] - p_LB_m) * (smooth_m[i] / part.depth_m[i]);
    const bool keep = on_target.empty() ? moved_L_m.z() > background.floor_margin_m : on_target[i];
    if (keep) target.p_L_m[kept++] = moved_L_m;
  }
  target.p_L_m.resize(kept);
  target.segments = FindSegments(target.p_L_m, segments);
  return target;
}

}  // namespace geon::recognition
