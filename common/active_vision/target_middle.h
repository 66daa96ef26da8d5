#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "sensor/scan_set.h"

namespace geon::active_vision {

// Where a scanned target stands: the middle, seen from above, of what its profiles show of it, in
// the level frame L of the scan. The six stripes run over its front, its top and both its edges, so
// that the middle of their extent is the target's own to some centimetres whatever its shape; what
// its far side hides is not known.
//
// `foot_m` is where the target was believed to stand: points farther than 0.3 m from there, on the
// support, or not of the target's colour are something else's. Nothing when too few are left.
// Source: ours.
std::optional<Eigen::Vector2d> TargetMiddle(std::span<const sensor::RangeProfile> profiles,
                                            const Eigen::Vector2d& foot_L_m);

}  // namespace geon::active_vision
