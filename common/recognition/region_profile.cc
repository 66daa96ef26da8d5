#include "recognition/region_profile.h"

#include "recognition/profile_noise.h"

namespace geon::recognition {
namespace {

// VerticalRegion::Holds for every point of a scan, with two products a point: the normals, into the
// region, of the two planes through the camera's centre that bound it.
struct Sides {
  Eigen::Vector3d left_L, right_L;
};

Sides SidesOf(const VerticalRegion& region, const BwCamera& camera) {
  const Eigen::Vector3d right_L = camera.R_LB.col(0), forward_L = camera.R_LB.col(2);
  return {right_L - region.min_tangent_1 * forward_L, region.max_tangent_1 * forward_L - right_L};
}

}  // namespace

RegionProfile FindRegionProfile(const sensor::RangeProfile& profile, const sensor::ScanSet& scan,
                                const std::optional<VerticalRegion>& region) {
  RegionProfile part;
  part.laser = profile.laser;
  part.fraction = profile.fraction;
  part.camera = CameraAtStripe(scan, profile);
  const size_t n = profile.p_L_m.size();
  part.pixel.resize(n);
  part.p_L_m.resize(n);
  part.depth_m.resize(n);
  part.on_color_1.resize(profile.on_color_1.size());
  const Eigen::Vector3d p_LB_m = part.camera.p_LB_m, forward_L = part.camera.R_LB.col(2);
  const Sides sides = region ? SidesOf(*region, CameraAtTarget(scan)) : Sides{forward_L, forward_L};
  size_t kept = 0;
  for (size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d p_BoP_L = profile.p_L_m[i] - p_LB_m;
    const double depth_m = forward_L.dot(p_BoP_L);
    part.pixel[kept] = profile.pixel[i];
    part.p_L_m[kept] = profile.p_L_m[i];
    part.depth_m[kept] = depth_m;
    if (!part.on_color_1.empty()) part.on_color_1[kept] = profile.on_color_1[i];
    const bool within = sides.left_L.dot(p_BoP_L) >= 0.0 && sides.right_L.dot(p_BoP_L) >= 0.0;
    if (within && depth_m > 0.0) ++kept;  // else the next one takes its place
  }
  part.pixel.resize(kept);
  part.p_L_m.resize(kept);
  part.depth_m.resize(kept);
  if (!part.on_color_1.empty()) part.on_color_1.resize(kept);
  part.noise_m = DepthNoise(part.pixel, part.depth_m);
  return part;
}

std::vector<RegionProfile> FindRegionProfiles(const sensor::ScanSet& scan,
                                              const std::optional<VerticalRegion>& region) {
  std::vector<RegionProfile> parts;
  parts.reserve(scan.profiles.size());
  for (const sensor::RangeProfile& profile : scan.profiles) {
    parts.push_back(FindRegionProfile(profile, scan, region));
  }
  return parts;
}

}  // namespace geon::recognition
