#pragma once

#include <span>

#include "recognition/profile_ends.h"
#include "sensor/geon_verdict.h"

namespace geon::recognition {

struct BendingOptions {
  // k_tol of (5.3). The thesis prints no value; this is several times the noise of an end point.
  double concave_edge_m = 0.00097;
  // The tolerance grows by this much of the distance from p1 to p3: perspective bends the outline
  // of a straight body a little, in proportion to its size.
  double concave_edge_1 = 0.0;
  void Validate() const;  // throws ContractViolation
};

// Evidence of bending: a profile in two segments, a concavity, or a concave edge through the end
// points on any of the four sides.
//
// Source: thesis section 5.4, equation 5.3, figures 5.10-5.12. Deviations: the line from p1 to p3
// is taken at p2's own place, as the text says, not half-way as printed (they agree for equal
// steps); and in the perspective image, scaled to metres at p2's distance, where a straight edge is
// a straight line whatever its direction in depth.
sensor::BendingEvidence FindBending(std::span<const sensor::ProfileEvidence> profiles,
                                    std::span<const ProfileEnds> horizontal,
                                    std::span<const ProfileEnds> vertical,
                                    const BendingOptions& options);

}  // namespace geon::recognition
