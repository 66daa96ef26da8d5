#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "recognition/bw_camera.h"
#include "recognition/remove_background.h"
#include "sensor/scan_set.h"

namespace geon::recognition {

// What one profile shows of the vertical region of interest: of all of the scene when there is no
// region. Both methods start from it.
struct RegionProfile {
  sensor::Laser laser = sensor::Laser::kHorizontal;
  double fraction = 0.5;
  BwCamera camera;  // as it stood at this stripe
  // One of each a point, in the order of the pixels.
  std::vector<int> pixel;
  std::vector<Eigen::Vector3d> p_L_m;
  std::vector<double> depth_m;     // along z of `camera`
  std::vector<double> on_color_1;  // as the profile's; empty: not known
  double noise_m = 0.0;            // of the depths (profile_noise.h)
};

// Source: thesis section 5.1, figure 5.3. Points behind the camera are dropped. The thesis smooths
// before it removes background; smoothing moves points along their viewing rays, hence neither into
// the region nor out of it. `region` as from FindVerticalRegion; a profile has a pixel for each
// point.
RegionProfile FindRegionProfile(const sensor::RangeProfile& profile, const sensor::ScanSet& scan,
                                const std::optional<VerticalRegion>& region);

// Of all profiles of a scan, in their order.
std::vector<RegionProfile> FindRegionProfiles(const sensor::ScanSet& scan,
                                              const std::optional<VerticalRegion>& region);

}  // namespace geon::recognition
