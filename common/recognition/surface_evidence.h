#pragma once

#include "recognition/evidence_list.h"
#include "recognition/stripe_crossings.h"

namespace geon::recognition {

// What the nine crossings of three horizontal with three vertical stripes say about the surface:
// its normals there, how it curves between neighbours, whether they lie in one plane.
//
// Source: ours; the thesis reads each stripe by itself. `scale_m` is the mean length of the
// stripes. A crossing that does not exist gives zeros.
void AddSurfaceEvidence(const CrossingGrid& grid, double scale_m, EvidenceList* evidence);

}  // namespace geon::recognition
