#include "attention/adapt_color_model.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "attention/rgb_image.h"
#include "base/median.h"

namespace geon::attention {
namespace {

constexpr int kDarkLevel = 40;  // darker: the ratios are mostly noise
constexpr int kClippedLevel = 250;

std::vector<HalfSpaceColor> Adapted(std::vector<HalfSpaceColor> regions, const LightGain& gain) {
  for (HalfSpaceColor& region : regions) {
    for (ColorHalfSpace& plane : region.half_spaces) {
      if (plane.threshold_1 != 0.0) continue;
      plane =
          WholeNumbered({plane.red_1 / gain.red_1, plane.green_1, plane.blue_1 / gain.blue_1, 0.0});
    }
  }
  return regions;
}

}  // namespace

std::optional<LightGain> MeasureLightGain(const sensor::Image& image, const Rgb& known) {
  Require(known.red > 0 && known.green > 0 && known.blue > 0,
          "MeasureLightGain: the known colour has an empty channel");
  const RgbImage pixels(image);
  std::vector<double> red_1, blue_1;
  for (int v = 0; v < image.height_px; ++v) {
    for (int u = 0; u < image.width_px; ++u) {
      const Rgb rgb = pixels.At(u, v);
      if (std::max({rgb.red, rgb.green, rgb.blue}) >= kClippedLevel) continue;
      if (std::min({rgb.red, rgb.green, rgb.blue}) < kDarkLevel) continue;
      red_1.push_back(static_cast<double>(rgb.red) / rgb.green);
      blue_1.push_back(static_cast<double>(rgb.blue) / rgb.green);
    }
  }
  const size_t all = static_cast<size_t>(image.width_px) * static_cast<size_t>(image.height_px);
  if (red_1.empty() || red_1.size() < all / 10) return std::nullopt;
  return LightGain{Median(std::move(red_1)) * known.green / known.red,
                   Median(std::move(blue_1)) * known.green / known.blue};
}

sensor::Image UnderNeutralLight(const sensor::Image& image, const LightGain& gain) {
  Require(gain.red_1 > 0.0 && gain.blue_1 > 0.0, "LightGain must be positive");
  const RgbImage checked(image);
  const bool red_first = image.format == sensor::PixelFormat::kRgb8;
  const double factors[3] = {1.0 / (red_first ? gain.red_1 : gain.blue_1), 1.0,
                             1.0 / (red_first ? gain.blue_1 : gain.red_1)};
  sensor::Image neutral = image;
  for (int v = 0; v < checked.height_px(); ++v) {
    uint8_t* row =
        neutral.data.data() + static_cast<size_t>(v) * static_cast<size_t>(image.row_stride_bytes);
    for (int k = 0; k < 3 * image.width_px; ++k) {
      row[k] = static_cast<uint8_t>(std::lround(std::min(255.0, row[k] * factors[k % 3])));
    }
  }
  return neutral;
}

ColorModel AdaptColorModel(const ColorModel& model, const LightGain& gain) {
  Require(gain.red_1 > 0.0 && gain.blue_1 > 0.0, "LightGain must be positive");
  ColorModel adapted = model;
  adapted.target = Adapted(model.target, gain);
  adapted.rim = Adapted(model.rim, gain);
  return adapted;
}

}  // namespace geon::attention
