#pragma once

#include <cstdint>
#include <vector>

namespace geon::rangefinder {

constexpr int kWindowPad = 8;  // weights are padded with zeros to a multiple of this
constexpr int kMostWindowPixels = 64;

// Weights of the moments of a profile: a Gaussian of standard deviation sigma_px round the middle
// of a window, in fixed point.
//
// Source: ours (stripe_fit.h).
struct MomentWindow {
  double sigma_px = 0.0;
  int reach = 0;                   // pixels on either side of the middle
  int pixels = 0;                  // middle on a pixel: 2 reach + 1; between two: 2 reach
  std::vector<int16_t> weight[3];  // times 1, x and x^2, padded to a multiple of kWindowPad
  double unit[3] = {};             // of a weight
  double sum[3] = {};
};

// The window for a stripe of that width, of those kept: 0.7 to 10 px in steps of 15 %. Its middle
// lies on a pixel or halfway between two.
const MomentWindow& WindowFor(double sigma_px, bool middle_on_pixel);

// The width of a Gaussian that gives a run of `length` pixels where it is cut at 1 / `ratio` of its
// height.
double SigmaOfRun(int length, double ratio);

}  // namespace geon::rangefinder
