#pragma once

#include <span>

#include "recognition/profile_ends.h"
#include "sensor/geon_verdict.h"

namespace geon::recognition {

struct TaperingOptions {
  // Lengths count as different (5.4-5.7) when they differ by more than this and this fraction:
  // noise alone would make three equal lengths monotone one time in three.
  double length_tolerance_m = 0.006;
  double length_tolerance_1 = 0.02;
  double asymmetry_m = 0.030;  // k_tol of (5.8); the thesis prints no value
  void Validate() const;       // throws ContractViolation
};

// Evidence of tapering: lengths that rise or fall from stripe to stripe (5.4-5.7), or ends that
// step unequally left and right, or top and bottom (5.8).
//
// Source: thesis section 5.5, figures 5.14 and 5.15. Bent geons show it too: it means tapering only
// where no bending was found.
sensor::TaperingEvidence FindTapering(std::span<const ProfileEnds> horizontal,
                                      std::span<const ProfileEnds> vertical,
                                      const TaperingOptions& options);

}  // namespace geon::recognition
