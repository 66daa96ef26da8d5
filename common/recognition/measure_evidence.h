#pragma once

#include "recognition/evidence_list.h"
#include "recognition/target_stripe.h"

namespace geon::recognition {

// Everything that method `evidence` weighs, kept continuous: what each stripe's form says
// (stripe_evidence.h), the outline (outline_evidence.h), the surface (surface_evidence.h), and the
// view as a whole. Always the same number of values in the same order.
//
// Source: thesis sections 5.3 to 5.5 without their thresholds; the surface is ours.
// `p_LB_m`, `R_LB`: the B/W camera of the scan in frame L.
EvidenceList MeasureEvidence(const std::vector<TargetStripe>& stripes,
                             const Eigen::Vector3d& p_LB_m, const Eigen::Matrix3d& R_LB,
                             bool with_names = false);

}  // namespace geon::recognition
