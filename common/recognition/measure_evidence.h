#pragma once

#include "recognition/evidence_list.h"
#include "recognition/recognition_options.h"
#include "recognition/target_stripe.h"

namespace geon::recognition {

// Everything that method `evidence` weighs, kept continuous: what each stripe's form says
// (stripe_evidence.h), the outline (outline_evidence.h), the surface (surface_evidence.h), its
// faces (face_evidence.h), how a cone fits (round_evidence.h), and the view as a whole. Always the
// same number of values in the same order.
//
// Source: thesis sections 5.3 to 5.5 without their thresholds; the surface is ours.
EvidenceList MeasureEvidence(const TargetView& view, bool with_names = false);

// The same of a scan: finds the target, then measures it.
EvidenceList MeasureScan(const sensor::ScanSet& scan, const RecognitionOptions& options = {},
                         bool with_names = false);

}  // namespace geon::recognition
