#pragma once

#include <span>
#include <vector>

namespace geon::recognition {

enum class Smoothing { kNone, kMedian, kGaussian };

struct SmoothingOptions {
  Smoothing kind = Smoothing::kMedian;
  // The window reaches this far to each side of a pixel. The thesis names no size; 7 came out of
  // the search for the thresholds it leaves open (docs/experiments.md).
  int half_width_px = 7;
  double gaussian_sigma_px = 1.2;
  void Validate() const;  // throws ContractViolation
};

// The depths of a profile (z of the B/W camera), one for each of `pixel`, smoothed along the
// stripe; with Smoothing::kNone all stay.
//
// Source: thesis section 5.1 and figure 5.2: the median, because a Gaussian spreads a spike to its
// neighbours. The quantity smoothed is z of the B/W camera, which the rangefinder measures per
// pixel (3.7-3.9); every point then moves along its own viewing ray (3.10). The window ends at a
// missing pixel: nothing is smoothed across a gap.
std::vector<double> SmoothDepths(std::span<const int> pixel, std::span<const double> depth_m,
                                 const SmoothingOptions& options);

}  // namespace geon::recognition
