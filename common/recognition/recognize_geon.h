#pragma once

#include "recognition/recognition_options.h"
#include "sensor/geon_verdict.h"
#include "sensor/scan_set.h"

namespace geon::recognition {

// Names the geon that a scan set shows, with the evidence and the reasons in words.
//
// Source: thesis chapter 5, the six stages of figure 5.1: smoothing, background removal, corners,
// curves and lines of each profile, evidence of bending, evidence of tapering, decision tree.
//
// Thresholds: those the thesis leaves open were searched with `geon experiment tune` on scans of
// random shapes; docs/experiments.md has the rates.
//
// Deterministic: the same scan set and options give the same verdict bit for bit. The scan's
// `truth` is never looked at; utime, seq are left 0 and scan_id is the scan's. Outcomes: `decided`
// is false when less than one horizontal or vertical profile shows the target; the label is then
// the best guess on what is there and its confidence that of a guess. Throws
// ContractViolation when options are invalid or a profile's pixel and point counts differ.
//
// Method `evidence` looks at the same profiles but decides otherwise: what thesis stages 3 to 5
// turn into YES and NO stays a number (measure_evidence.h), and a forest trained on random shapes
// (geon_forest.h, `geon train`) weighs the numbers. Its posterior is calibrated and `decided` says
// whether it is high enough to be relied on. Bending, tapering and the profiles' features are
// reported beside it, as the thesis finds them.
sensor::GeonVerdict RecognizeGeon(const sensor::ScanSet& scan, const RecognitionOptions& options);

}  // namespace geon::recognition
