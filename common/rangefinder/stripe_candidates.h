#pragma once

#include <vector>

#include "rangefinder/stripe_peaks.h"
#include "rangefinder/stripe_pieces.h"

namespace geon::rangefinder {

// The level and noise of what is not stripe, from a sample of the image: median and 84 % point,
// which the stripe's few pixels do not move; right also where the subtraction of the unlit frame
// cut the noise off at 0.
//
// Source: ours.
Background MeasureBackground(const sensor::Image& gray);

// The bright spots that may be the stripe, at most options.max_candidates in a line, by line: every
// run of pixels above the threshold, measured as options.method says. A run that is no single
// profile (two crests, light scattered round the stripe, glare) is taken apart, brightest first.
std::vector<PeakCandidate> FindCandidates(const sensor::Image& gray, sensor::Laser laser,
                                          const Background& background, const PeakOptions& options);

}  // namespace geon::rangefinder
