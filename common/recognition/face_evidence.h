#pragma once

#include <vector>

#include "recognition/evidence_list.h"
#include "recognition/stripe_crossings.h"
#include "recognition/target_stripe.h"

namespace geon::recognition {

// Whether the target is a block of right angles: how its faces, as far as stripes cross on them,
// and the edges of its outline stand to each other and to the support.
//
// Source: ours, in place of thesis (5.8), which takes tapering from lengths alone and so misses a
// wedge whose lengths perspective hides. `stripes` three horizontal, then three vertical ones, as
// in TargetView; what they do not show gives zeros.
void AddFaceEvidence(const std::vector<TargetStripe>& stripes, const CrossingGrid& grid,
                     EvidenceList* evidence);

}  // namespace geon::recognition
