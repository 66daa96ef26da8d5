#include "attention/color_space.h"

#include <algorithm>
#include <cmath>

namespace geon::attention {

Yiq YiqFromRgb(const Rgb& rgb) {
  const double r = rgb.red;
  const double g = rgb.green;
  const double b = rgb.blue;
  return {0.299 * r + 0.114 * b + 0.587 * g,   // (4.4)
          0.596 * r - 0.322 * b - 0.274 * g,   // (4.5)
          0.211 * r + 0.312 * b - 0.523 * g};  // (4.6)
}

Hsi HsiFromRgb(const Rgb& rgb) {
  const double r = rgb.red;
  const double g = rgb.green;
  const double b = rgb.blue;
  const double sum = r + g + b;
  Hsi hsi;
  hsi.hue_rad = std::atan2(std::sqrt(3.0) * (g - b), 2.0 * r - g - b);      // (4.7)
  if (sum > 0.0) hsi.saturation_1 = 1.0 - 3.0 * std::min({r, g, b}) / sum;  // (4.8)
  hsi.intensity_1 = sum / 3.0;                                              // (4.9)
  return hsi;
}

}  // namespace geon::attention
