#pragma once

#include <array>
#include <cstdint>

namespace geon::rangefinder {

constexpr int kMostWindowPixels = 64;

// Weights of the moments of a profile: a Gaussian of standard deviation sigma_px round the middle
// of a window, in fixed point.
//
// Source: ours (stripe_fit.h).
struct MomentWindow {
  float sigma_px = 0.0F;
  int reach = 0;   // pixels on either side of the middle
  int pixels = 0;  // middle on a pixel: 2 reach + 1; between two: 2 reach
  // Times 1, x and x^2; 0 beyond the window.
  std::array<std::array<int16_t, kMostWindowPixels>, 3> weight{};
  float unit[3] = {};  // of a weight
  float sum[3] = {};
};

// The window for a stripe of that width, of those kept: 0.7 to 10 px in steps of 15 %. Its middle
// lies on a pixel or halfway between two.
const MomentWindow& WindowFor(float sigma_px, bool middle_on_pixel);

// The width of a Gaussian that gives a run of `length` pixels where it is cut at 1 / `ratio` of its
// height.
float SigmaOfRun(int length, float ratio);

}  // namespace geon::rangefinder
