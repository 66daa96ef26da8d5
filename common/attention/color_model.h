#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "attention/color_space.h"

namespace geon::attention {

// The pixels with red_1 * r + green_1 * g + blue_1 * b > threshold_1.
struct ColorHalfSpace {
  double red_1 = 0.0;
  double green_1 = 0.0;
  double blue_1 = 0.0;
  double threshold_1 = 0.0;
};

// The intersection of half-spaces of RGB: a colour as the thesis describes it.
struct HalfSpaceColor {
  std::vector<ColorHalfSpace> half_spaces;
};

// A colour learned from samples (learn_color_model.h): an ellipse in the plane of chrominance over
// luminance (I/Y, Q/Y), which brightness does not move, down to a brightness where that ratio still
// means something.
struct ChromaticityColor {
  double mean_i_1 = 0.0;  // of I/Y
  double mean_q_1 = 0.0;  // of Q/Y
  // Inverse covariance of (I/Y, Q/Y).
  double inverse_ii_1 = 1.0;
  double inverse_iq_1 = 0.0;
  double inverse_qq_1 = 1.0;
  double max_distance_1 = 3.0;   // Mahalanobis distance of the ellipse's rim
  double min_luminance_1 = 0.0;  // of Y
};

// Which pixels have the target's colour.
//
// Source: thesis section 4.1.2. Named models:
//   super-red       r > g + b + 20
//   thesis-lab      equations 4.10-4.17, one lamp
//   thesis-lab-sun  equations 4.18-4.26, lamp and sun; 4.24 as the errata read it, g > 0.44 r
//   - 50.6
struct ColorModel {
  std::string name;
  std::variant<HalfSpaceColor, ChromaticityColor> color;

  bool Contains(const Rgb& pixel) const;
};

// Nothing for a name that is none of NamedColorModels().
std::optional<ColorModel> NamedColorModel(std::string_view name);
std::vector<std::string> NamedColorModels();

}  // namespace geon::attention
