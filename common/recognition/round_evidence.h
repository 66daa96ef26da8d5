#pragma once

#include <vector>

#include "recognition/evidence_list.h"
#include "recognition/stripe_crossings.h"
#include "recognition/target_stripe.h"

namespace geon::recognition {

// How well a cylinder or cone fits the target, and how much it tapers (cone_fit.h): misfit, slope,
// how far the radius grows over the target relative to itself, radius and axis.
//
// Source: ours; the thesis's evidence of tapering (section 5.5) reads lengths of stripes and cannot
// tell a cylinder that lies askew. `scale_m` is the mean length of the stripes.
void AddRoundEvidence(const std::vector<TargetStripe>& stripes, const CrossingGrid& grid,
                      double scale_m, EvidenceList* evidence);

}  // namespace geon::recognition
