#pragma once

#include <random>
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

}  // namespace geon::evaluation
