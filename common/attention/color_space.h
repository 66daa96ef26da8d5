#pragma once

#include <cstdint>

namespace geon::attention {

// One pixel, 0 ... 255 a channel, as the camera delivered it.
struct Rgb {
  uint8_t red = 0;
  uint8_t green = 0;
  uint8_t blue = 0;
};

// Luminance, in-phase and quadrature chrominance.
//
// Source: thesis 4.1.1, equations 4.4-4.6 (channel order R, B, G, as the errata say of 4.3).
struct Yiq {
  double luminance_1 = 0.0;   // Y, 0 ... 255
  double in_phase_1 = 0.0;    // I
  double quadrature_1 = 0.0;  // Q
};
Yiq YiqFromRgb(const Rgb& rgb);

// Hue, saturation and intensity: the description people understand.
//
// Source: thesis 4.1.1, equations 4.7-4.9; 4.7 as the errata read it, atan2(sqrt(3)(G-B), 2R-G-B).
// Hue is 0 for a grey, saturation 0 for black.
struct Hsi {
  double hue_rad = 0.0;       // (-pi, pi], 0 is red
  double saturation_1 = 0.0;  // 0 ... 1
  double intensity_1 = 0.0;   // 0 ... 255
};
Hsi HsiFromRgb(const Rgb& rgb);

}  // namespace geon::attention
