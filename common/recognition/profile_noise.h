#pragma once

#include <span>

namespace geon::recognition {

// Standard deviation of a profile's depth (z of the B/W camera) from pixel to pixel, in metres,
// measured on the profile itself before smoothing; a depth for each of `pixel`.
//
// Not in the thesis, which has one sensor at about one distance: its thresholds, in absolute
// figures, would call noise a curve at 1.6 m, where it is 2.5 times that at 1.0 m.
// Source: third differences of neighbouring pixels cancel every parabola; their median magnitude is
// not moved by edges and spikes. 0 when fewer than four neighbouring pixels are there.
double DepthNoise(std::span<const int> pixel, std::span<const double> depth_m);

}  // namespace geon::recognition
