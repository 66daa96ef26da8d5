#pragma once

#include <random>
#include <span>
#include <vector>

#include "evaluation/scan_conditions.h"

namespace geon::evaluation {

// What is wrong with a stripe's peak in one line of the image.
struct StripeError {
  double offset_px = 0.0;
  bool missing = false;
};

// The errors of `lines` neighbouring lines: white noise, speckle (a first-order autoregression over
// about four lines), peaks that are reflections from elsewhere, and lines without a peak.
std::vector<StripeError> StripeErrors(size_t lines, const FaultOptions& faults,
                                      std::mt19937_64& random);

// The depths (infinity: none) as a sensor sees them that matches patches: averaged, displaced along
// the stripe, missing beside jumps. As they are when none of these faults is asked for.
//
// Source: Khoshelham and Elberink, "Accuracy and resolution of Kinect depth data", 2012, section 3,
// for what such sensors do at edges; the forms are ours.
std::vector<double> MatchPatches(std::span<const double> depths_m, const FaultOptions& faults,
                                 std::mt19937_64& random);

}  // namespace geon::evaluation
