#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "attention/color_space.h"

namespace geon::attention {

// The colours with red_1 * r + green_1 * g + blue_1 * b > threshold_1, summed in this order in
// double precision.
struct ColorHalfSpace {
  double red_1 = 0.0;
  double green_1 = 0.0;
  double blue_1 = 0.0;
  double threshold_1 = 0.0;

  bool Contains(const Rgb& pixel) const {
    return red_1 * pixel.red + green_1 * pixel.green + blue_1 * pixel.blue > threshold_1;
  }
  friend bool operator==(const ColorHalfSpace&, const ColorHalfSpace&) = default;
};

// The intersection of half-spaces of RGB: a colour as the thesis describes it. A cone of planes
// through black is a polygon of chromaticity, which brightness does not move.
struct HalfSpaceColor {
  std::vector<ColorHalfSpace> half_spaces;

  bool Contains(const Rgb& pixel) const;
  friend bool operator==(const HalfSpaceColor&, const HalfSpaceColor&) = default;
};

// What a colour says by itself. kRim and kCannotTell are settled by the pixels around
// (resolve_color.h).
enum class ColorClass : uint8_t { kOther, kTarget, kRim, kCannotTell };

// Which pixels have the target's colour. The first of these that holds:
//   kTarget      in one of the regions `target`
//   kRim         in one of the regions `rim`: target where connected to target pixels
//   kCannotTell  largest channel below dark_level_1, or at or above clipped_level_1
//   kOther
// A model whose target must not hold dark or clipped colours says so in its half-spaces.
//
// Source: thesis section 4.1.2; planes through black: Tosas and Mills (2007). Named models,
// without rim or levels:
//   super-red       r > g + b + 20
//   thesis-lab      equations 4.10-4.17, one lamp
//   thesis-lab-sun  equations 4.18-4.26, lamp and sun; 4.24 as the errata read it, g > 0.44 r
//   - 50.6
struct ColorModel {
  std::string name;
  std::vector<HalfSpaceColor> target;
  std::vector<HalfSpaceColor> rim;
  int dark_level_1 = 0;       // 0: never too dark
  int clipped_level_1 = 256;  // 256: never clipped

  ColorClass Classify(const Rgb& pixel) const;
  // What is wrong with the values; nothing when they are good.
  std::optional<std::string> Validate() const;
  friend bool operator==(const ColorModel&, const ColorModel&) = default;
};

// The nearest plane whose coefficients are whole and at most 128 in sum of magnitudes, its
// threshold scaled alike: what 16-bit arithmetic decides exactly, and fast (classify_pixels.h).
// Learned planes should be such ones.
ColorHalfSpace WholeNumbered(const ColorHalfSpace& half_space);

// The same colours in a picture whose levels are all this share of what they could be: what is the
// target's colour when exposed longer. 0 < level_1 <= 1 (ContractViolation).
ColorModel AtLevel(const ColorModel& model, double level_1);

// Nothing for a name that is none of NamedColorModels().
std::optional<ColorModel> NamedColorModel(std::string_view name);
std::vector<std::string> NamedColorModels();

}  // namespace geon::attention
