#include "sim/material.h"

#include <algorithm>
#include <cmath>

namespace geon::sim {

Material Paint(const Eigen::Vector3d& color_rgb, std::optional<double> laser_reflectance_1) {
  Material material;
  for (int c = 0; c < 3; ++c) {
    material.color_1[c] = static_cast<float>(std::pow(color_rgb[c] / 255.0, kGamma_1));
  }
  const double sum = std::max(1.0, color_rgb.sum());
  const double redness_1 = color_rgb[0] / sum;  // a third for a grey, 1 for pure red
  const double guess_1 = material.color_1[0] * (0.5 + 1.5 * redness_1);
  material.laser_reflectance_1 =
      static_cast<float>(std::clamp(laser_reflectance_1.value_or(guess_1), 0.0, 1.0));
  return material;
}

}  // namespace geon::sim
