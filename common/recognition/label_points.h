#pragma once

#include <optional>
#include <span>
#include <vector>

#include "recognition/region_profile.h"
#include "recognition/remove_background.h"
#include "recognition/support_plane.h"
#include "recognition/wall_plane.h"
#include "sensor/scan_set.h"

namespace geon::recognition {

// What a scan shows of the target's background, and what remains.
struct ScanLabels {
  std::optional<SupportPlane> support;
  std::optional<WallPlane> wall;
  // For each point of each region profile whether it lies on the target.
  std::vector<std::vector<bool>> on_target;
};

// Tells the target from its background by the scan's own points.
//
// Steps: the support is fitted to what lies beside the target (support_plane.h), and so is a wall;
// along each stripe the likeliest sequence of target and background is found, where background is
// what lies on those planes or below the support, within the profile's noise, or lacks the target's
// colour where that is known, and where a change costs much unless the stripe jumps; where target
// and support meet, the border is where the target's own slope meets the support; a piece of target
// whose middle lies outside the rows or columns of the target is background after all.
//
// Source: Viterbi, "Error bounds for convolutional codes and an asymptotically optimum decoding
// algorithm", 1967, over two states. The thesis's own tests (5.1) are in remove_background.h.
// Without a support plane its height of 1 cm above z = 0 takes the plane's place.
//
// With BackgroundMethod::kThesis nothing is fitted, and a point is the target's when it lies higher
// than `floor_margin_m`.
//
// `region` as from FindVerticalRegion, `parts` as from FindRegionProfiles of the same scan.
ScanLabels LabelPoints(const sensor::ScanSet& scan, const std::optional<VerticalRegion>& region,
                       std::span<const RegionProfile> parts, const BackgroundOptions& options);

// For each point of each profile of the scan whether it lies on the target, by either method.
std::vector<std::vector<bool>> FindTargetPoints(const sensor::ScanSet& scan,
                                                const BackgroundOptions& options);

}  // namespace geon::recognition
