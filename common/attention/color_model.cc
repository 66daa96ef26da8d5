#include "attention/color_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/contracts.h"

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

// A region that no half-space bounds would hold every colour.
std::optional<std::string> ValidateRegions(const std::vector<HalfSpaceColor>& regions) {
  for (const HalfSpaceColor& region : regions) {
    if (region.half_spaces.empty()) return "a region has no half-space";
    for (const ColorHalfSpace& half_space : region.half_spaces) {
      if (!std::isfinite(half_space.red_1) || !std::isfinite(half_space.green_1) ||
          !std::isfinite(half_space.blue_1) || !std::isfinite(half_space.threshold_1)) {
        return "a half-space has a number that is not finite";
      }
    }
  }
  return std::nullopt;
}

bool AnyContains(const std::vector<HalfSpaceColor>& regions, const Rgb& pixel) {
  return std::any_of(regions.begin(), regions.end(),
                     [&pixel](const HalfSpaceColor& region) { return region.Contains(pixel); });
}

}  // namespace

bool HalfSpaceColor::Contains(const Rgb& pixel) const {
  return std::all_of(
      half_spaces.begin(), half_spaces.end(),
      [&pixel](const ColorHalfSpace& half_space) { return half_space.Contains(pixel); });
}

ColorClass ColorModel::Classify(const Rgb& pixel) const {
  if (AnyContains(target, pixel)) return ColorClass::kTarget;
  if (AnyContains(rim, pixel)) return ColorClass::kRim;
  const int largest = std::max({pixel.red, pixel.green, pixel.blue});
  const bool cannot_tell = largest < dark_level_1 || largest >= clipped_level_1;
  return cannot_tell ? ColorClass::kCannotTell : ColorClass::kOther;
}

std::optional<std::string> ColorModel::Validate() const {
  if (target.empty()) return "a colour needs at least one region of the target";
  if (const auto error = ValidateRegions(target)) return error;
  if (const auto error = ValidateRegions(rim)) return error;
  if (dark_level_1 < 0 || dark_level_1 > 255) {
    return "dark_level_1 is " + std::to_string(dark_level_1) + ", must be 0 ... 255";
  }
  if (clipped_level_1 <= dark_level_1 || clipped_level_1 > 256) {
    return "clipped_level_1 is " + std::to_string(clipped_level_1) +
           ", must be above dark_level_1 and at most 256";
  }
  return std::nullopt;
}

ColorHalfSpace WholeNumbered(const ColorHalfSpace& half_space) {
  const double sum =
      std::abs(half_space.red_1) + std::abs(half_space.green_1) + std::abs(half_space.blue_1);
  if (!(sum > 0.0)) return half_space;
  const double scale = (128.0 - 3 * 0.5) / sum;  // rounding may add a half to each
  return {std::round(half_space.red_1 * scale), std::round(half_space.green_1 * scale),
          std::round(half_space.blue_1 * scale), std::round(half_space.threshold_1 * scale)};
}

ColorModel AtLevel(const ColorModel& model, double level_1) {
  Require(level_1 > 0.0 && level_1 <= 1.0, "AtLevel: level_1", level_1, "must be within 0 and 1");
  ColorModel fainter = model;
  for (auto* regions : {&fainter.target, &fainter.rim}) {
    for (HalfSpaceColor& region : *regions) {
      for (ColorHalfSpace& half_space : region.half_spaces) half_space.threshold_1 *= level_1;
    }
  }
  fainter.dark_level_1 = static_cast<int>(level_1 * model.dark_level_1);
  return fainter;
}

std::optional<ColorModel> NamedColorModel(std::string_view name) {
  for (const NamedColor& color : NamedColors()) {
    if (color.name == name) return ColorModel{std::string(name), {{color.half_spaces}}, {}};
  }
  return std::nullopt;
}

std::vector<std::string> NamedColorModels() {
  std::vector<std::string> names;
  for (const NamedColor& color : NamedColors()) names.emplace_back(color.name);
  return names;
}

}  // namespace geon::attention
