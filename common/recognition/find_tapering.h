#pragma once

#include <span>

#include "recognition/profile_ends.h"
#include "sensor/geon_verdict.h"

namespace geon::recognition {

// How much a length or step must differ to count: an absolute part, for noise, and a part of the
// mean length of the profiles in that direction, for what perspective does to straight bodies.
struct TaperingTolerance {
  double absolute_m = 0.0;
  double relative_1 = 0.0;
};

struct TaperingOptions {
  // Lengths count as different (5.4-5.7) when they differ by more than this: noise alone would make
  // three equal lengths monotone one time in three. Vertical stripes cross the top and the front of
  // an object, which perspective foreshortens unequally: they need more.
  TaperingTolerance horizontal_length{0.0015, 0.014};
  TaperingTolerance vertical_length{0.0005, 0.048};
  // k_tol of (5.8) for each direction. The thesis prints no value.
  TaperingTolerance horizontal_step{0.037, 0.16};
  TaperingTolerance vertical_step{0.012, 0.019};
  void Validate() const;  // throws ContractViolation
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
