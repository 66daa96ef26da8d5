#pragma once

#include "sensor/image.h"

namespace geon::rangefinder {

// Source: thesis section 3.1.1 (optical filter) and 3.2 (averaged frames); errata to 3.6
// (difference).
enum class LaserColor { kMono, kRed, kGreen };

struct LaserLightOptions {
  int background_window_px = 41;  // of the local background, for images without an unlit twin
  int saturated_level = 250;      // a channel at or above hides how bright it was
};

// Lit minus unlit, saturating at 0 (errata to 3.6): the laser's channel of a colour image, the mean
// of all for kMono. Sizes and formats must agree.
sensor::Image LaserLight(const sensor::Image& lit, const sensor::Image& unlit, LaserColor color);

// Laser light in a single frame: brightness minus the local background (a median). In colour, only
// where the neighbourhood has the laser's colour, and at half scale: where the laser's channel is
// full, the others, which catch its overflow, count with it.
sensor::Image LaserLight(const sensor::Image& lit, LaserColor color,
                         const LaserLightOptions& options = {});

// The mean of frames of equal size (thesis 3.2: ten frames against random noise), rounded.
sensor::Image AverageImages(const std::vector<sensor::Image>& images);

}  // namespace geon::rangefinder
