#pragma once

#include <Eigen/Core>
#include <optional>

#include "sim/checks.h"

namespace geon::sim {

// What a surface does with light.
struct Material {
  Eigen::Vector3f color_1 =
      Eigen::Vector3f::Constant(0.5F);  // diffuse reflectance, linear red green blue
  float laser_reflectance_1 = 0.5F;     // at the lasers' 670 nm
  float gloss_1 = 0.04F;                // share of the lamp that is mirrored, spread as by paint
  float mirror_1 = 0.0F;                // of a level surface: share that is mirrored sharply
  float tile_m = 0.0F;                  // side of drawn floor tiles; 0: plain
  std::optional<Checks> checks;
};

// A paint that a camera with the usual gamma shows as `color_rgb` (0 to 255) under full light.
// Without a stated reflectance at 670 nm it is guessed from the red channel, higher for a saturated
// red, which reflects more and more towards the infrared.
Material Paint(const Eigen::Vector3d& color_rgb, std::optional<double> laser_reflectance_1 = {});

// The cameras' gamma: value in the image = linear light to the power of 1 / kGamma.
inline constexpr double kGamma_1 = 2.2;

}  // namespace geon::sim
