#pragma once

#include "recognition/evidence_list.h"
#include "recognition/target_stripe.h"

namespace geon::recognition {

// What the form of one stripe says: how it turns, how straight it is, where it leads.
//
// Source: thesis section 5.3. The theta-plot is kept as its quantiles, at two scales, instead of
// being cut into curves and corners by thresholds; beside it stand the residuals of a line, of two
// lines and of a circle, and the directions of the stripe in the level frame. Lengths are given in
// units of `scale_m`, the mean length of all stripes. An empty stripe gives zeros.
void AddStripeEvidence(const TargetStripe& stripe, double scale_m, EvidenceList* evidence);

}  // namespace geon::recognition
