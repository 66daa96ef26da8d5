#pragma once

#include <optional>

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

// The profile round a run of pixels at or above `level_1`, which lies above the background.
//
// Source: ours. Moments under a Gaussian window of about the stripe's own width: the product of two
// Gaussians is one, so the profile's position, width and height follow in closed form, and with
// equal widths the position is as good as that of a least-squares fit (it solves the same
// equation). Where the crest is clipped: least squares of a parabola through the logarithms of the
// flanks' pixels, each weighed by the square of its level (Guo 2011); where these are no
// Gaussian's, the centroid of what is left. Nothing where the light is no such profile: two crests,
// no flanks, or at the image's edge.
std::optional<ProfileFit> FitGaussian(const LineView& image, const Run& run, double level_1,
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
