#pragma once

#include <vector>

#include "recognition/evidence_list.h"
#include "recognition/target_stripe.h"

namespace geon::recognition {

// What the nine crossings of three horizontal with three vertical stripes say about the surface:
// its normals there, how it curves between neighbours, whether they lie in one plane.
//
// Source: ours. The thesis reads each stripe by itself; two stripes that cross give the two
// tangents that make a normal. `stripes` as from FindTargetStripes; `p_LB_m`, `R_LB` the B/W
// camera; `scale_m` the mean length of the stripes. A crossing that does not exist gives zeros.
void AddSurfaceEvidence(const std::vector<TargetStripe>& stripes, const Eigen::Vector3d& p_LB_m,
                        const Eigen::Matrix3d& R_LB, double scale_m, EvidenceList* evidence);

}  // namespace geon::recognition
