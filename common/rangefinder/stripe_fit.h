#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rangefinder/stripe_runs.h"

namespace geon::rangefinder {

// Light whose profile across the stripe is a Gaussian on a level floor, as measured in one line.
struct ProfileFit {
  double position_px = 0.0;
  double peak_1 = 0.0;    // grey levels above the floor
  double width_px = 0.0;  // standard deviation of the profile on the pixels
  double floor_1 = 0.0;   // the level it stands on
  // Variance of the position: px^2 per (grey level)^2 of noise that every pixel has, and per grey
  // level of variance that comes with each grey level of light (shot noise).
  double per_noise = 0.0;
  double per_gain = 0.0;
  // Pixels it was measured on, but for those of a clipped crest: [core_first, core_last].
  int first = 0;
  int last = 0;
  int core_first = 0;
  int core_last = -1;
};

constexpr int kSaturated = 250;  // grey level from which a pixel may hide how bright it was

// What an image holds besides the stripe.
struct Background {
  double level_1 = 0.0;
  double noise_1 = 0.0;  // standard deviation
};

constexpr int kFloorRing = 4;  // pixels on either side that tell the level a profile stands on

// That level beside pixels [first, last] of a line: the mean of both sides, or that of the darker
// one where noise does not explain the other's light.
inline double FloorBeside(const LineView& image, int line, int first, int last, double noise_1) {
  constexpr double kUnlike = 3.0 * 1.4142 / 2.0;  // 3 standard errors of a difference of sides
  constexpr int kNone = 255 * kFloorRing;
  const auto sum_of = [&](int begin) {
    int sum = 0;
    for (int i = begin; i < begin + kFloorRing; ++i) sum += image.At(line, i);
    return sum;
  };
  const bool before = first >= kFloorRing;
  const bool after = last + kFloorRing < image.length;
  const int left = before ? sum_of(first - kFloorRing) : kNone;
  const int right = after ? sum_of(last + 1) : kNone;
  const int darker = left < right ? left : right;
  const bool unlike = left + right - 2 * darker > kUnlike * kFloorRing * noise_1;
  if (!before || !after || unlike) return darker / double{kFloorRing};
  return (left + right) / (2.0 * kFloorRing);
}

// The profiles round runs of pixels at or above `level_1`, which lies above the background, in the
// runs' order.
//
// Source: ours. Moments under a window (stripe_moments.h). Where the crest is clipped: least
// squares of a parabola through the logarithms of the flanks' pixels, each weighed by the square of
// its level (Guo 2011); where these are no Gaussian's, the centroid of what is left. Nothing where
// the light is no such profile: two crests, no flanks, or at the image's edge.
std::vector<std::optional<ProfileFit>> FitGaussians(const LineView& image,
                                                    std::span<const Run> runs, double level_1,
                                                    const Background& background);

// Source: thesis equation 3.6 in a window round the run, on what rises above `base_fraction_1` of
// the peak. `half_window_px`: of the window, widened for a wider stripe.
std::optional<ProfileFit> MeasureCentroid(const LineView& image, const Run& run, double noise_1,
                                          double base_fraction_1, int half_window_px);

// How far the pixels of a fit lie from it, and what part of their noise is to be expected there.
struct Misfit {
  double square_sum_1 = 0.0;  // of the residuals, (grey levels)^2
  double light_1 = 0.0;       // grey levels of light whose shot noise they hold
  double freedom = 0.0;       // pixels whose other noise they hold; 0: nothing to learn from
};
Misfit MeasureMisfit(const LineView& image, int line, const ProfileFit& fit);

}  // namespace geon::rangefinder
