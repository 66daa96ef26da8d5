#include "attention/color_model.h"

#include <algorithm>
#include <array>

namespace geon::attention {
namespace {

struct NamedColor {
  std::string_view name;
  std::vector<ColorHalfSpace> half_spaces;
};

// Every row is one printed inequality, written as red r + green g + blue b > threshold.
const std::array<NamedColor, 3>& NamedColors() {
  static const std::array<NamedColor, 3> kColors = {{
      {"super-red", {{1.0, -1.0, -1.0, 20.0}}},
      {"thesis-lab",
       {
           {0.467, 0.0, -1.0, 7.0},    // (4.10) b < 0.467 r - 7
           {0.0, 0.0, -1.0, -75.0},    // (4.11) b < 75
           {1.0, 0.0, 0.0, 50.0},      // (4.12) r > 50
           {0.0, 1.333, -1.0, -10.0},  // (4.13) b < 1.333 g + 10
           {0.0, -1.333, 1.0, -86.7},  // (4.14) b > 1.333 g - 86.7
           {0.0, -1.0, 0.0, -115.0},   // (4.15) g < 115
           {0.639, -1.0, 0.0, 12.78},  // (4.16) g < 0.639 r - 12.78
           {-0.381, 1.0, 0.0, -45.7},  // (4.17) g > 0.381 r - 45.7
       }},
      {"thesis-lab-sun",
       {
           {0.75, 0.0, -1.0, 5.0},     // (4.18) b < 0.75 r - 5
           {0.0, 0.0, -1.0, -80.0},    // (4.19) b < 80
           {1.0, 0.0, 0.0, 50.0},      // (4.20) r > 50
           {0.0, 1.333, -1.0, -10.0},  // (4.21) b < 1.333 g + 10
           {0.0, -0.67, 1.0, -40.0},   // (4.22) b > 0.67 g - 40
           {0.0, -1.0, 0.0, -100.0},   // (4.23) g < 100
           {-0.44, 1.0, 0.0, -50.6},   // (4.24) g > 0.44 r - 50.6, as the errata read it
           {0.0, 1.0, 0.0, 30.0},      // (4.25) g > 30
           {0.58, -1.0, 0.0, -25.2},   // (4.26) g < 0.58 r + 25.2
       }},
  }};
  return kColors;
}

bool Contains(const HalfSpaceColor& color, const Rgb& pixel) {
  return std::all_of(color.half_spaces.begin(), color.half_spaces.end(),
                     [&pixel](const ColorHalfSpace& half_space) {
                       return half_space.red_1 * pixel.red + half_space.green_1 * pixel.green +
                                  half_space.blue_1 * pixel.blue >
                              half_space.threshold_1;
                     });
}

bool Contains(const ChromaticityColor& color, const Rgb& pixel) {
  const Yiq yiq = YiqFromRgb(pixel);
  if (yiq.luminance_1 < color.min_luminance_1 || yiq.luminance_1 <= 0.0) return false;
  const double i = yiq.in_phase_1 / yiq.luminance_1 - color.mean_i_1;
  const double q = yiq.quadrature_1 / yiq.luminance_1 - color.mean_q_1;
  const double squared_distance =
      color.inverse_ii_1 * i * i + 2.0 * color.inverse_iq_1 * i * q + color.inverse_qq_1 * q * q;
  return squared_distance <= color.max_distance_1 * color.max_distance_1;
}

}  // namespace

bool ColorModel::Contains(const Rgb& pixel) const {
  return std::visit([&pixel](const auto& kind) { return attention::Contains(kind, pixel); }, color);
}

std::optional<ColorModel> NamedColorModel(std::string_view name) {
  for (const NamedColor& color : NamedColors()) {
    if (color.name == name) return ColorModel{std::string(name), HalfSpaceColor{color.half_spaces}};
  }
  return std::nullopt;
}

std::vector<std::string> NamedColorModels() {
  std::vector<std::string> names;
  for (const NamedColor& color : NamedColors()) names.emplace_back(color.name);
  return names;
}

}  // namespace geon::attention
