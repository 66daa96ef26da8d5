#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "recognition/bw_camera.h"
#include "recognition/target_extent.h"
#include "sensor/scan_set.h"

namespace geon::recognition {

// Where in the picture a block lies.
enum class BlockPlace {
  kOnTarget,  // in the target's columns (horizontal stripe) or rows (vertical stripe)
  kAtFoot,    // of a vertical stripe, in the lowest of those rows: target or support
  kBeside,    // outside them
};

// A few neighbouring points of a stripe that hang together, as one: what planes are fitted to.
struct StripeBlock {
  Eigen::Vector3d p_L_m;    // their mean
  Eigen::Vector3d along_L;  // unit, from the first of them to the last
  double noise_m = 0.0;     // of one point, along its ray
  int points = 0;
  BlockPlace place = BlockPlace::kOnTarget;
  size_t stripe = 0;  // which of the scan's profiles
};

// The blocks of all profiles of a scan, in the order of the pixels. `parts`: as from
// FindRegionProfiles, whose noise is the stripes'. `rows`: between which tangents
// y/z of the B/W camera the target lies; without them all blocks of a vertical stripe may be at its
// foot.
//
// Source: ours. A block is longer where the noise is larger, so that its direction means something.
std::vector<StripeBlock> FindStripeBlocks(const sensor::ScanSet& scan,
                                          const std::optional<VerticalRegion>& region,
                                          std::span<const RegionProfile> parts,
                                          const std::optional<Extent>& rows);

}  // namespace geon::recognition
