#pragma once

#include <vector>

#include "recognition/evidence_list.h"
#include "recognition/target_stripe.h"

namespace geon::recognition {

// What the twelve end points of the stripes say about the outline: whether its sides are straight,
// parallel, leaning, and whether the stripes grow from one to the next.
//
// Source: thesis sections 5.4 and 5.5, equations 5.3-5.8, as signed ratios of the geon's size
// instead of YES or NO, in the image (where a straight edge stays straight whatever its depth) and
// in space. `stripes` as from FindTargetView; `scale_m` the mean length of the stripes. A side with
// an empty stripe gives zeros.
void AddOutlineEvidence(const std::vector<TargetStripe>& stripes, const BwCamera& camera,
                        double scale_m, EvidenceList* evidence);

}  // namespace geon::recognition
