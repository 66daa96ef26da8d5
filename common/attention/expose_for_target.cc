#include "attention/expose_for_target.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "attention/rgb_image.h"

namespace geon::attention {
namespace {

using LevelCounts = std::array<int, 256>;

LevelCounts CountLevels(const RgbImage& image, std::span<const uint8_t> mask) {
  LevelCounts counts{};
  size_t pixel = 0;
  for (int v = 0; v < image.height_px(); ++v) {
    for (int u = 0; u < image.width_px(); ++u, ++pixel) {
      if (!mask.empty() && mask[pixel] == 0) continue;
      const Rgb rgb = image.At(u, v);
      ++counts[std::max({rgb.red, rgb.green, rgb.blue})];
    }
  }
  return counts;
}

// The least level that so large a share of the pixels does not exceed; nothing without pixels.
std::optional<double> LevelOf(const LevelCounts& counts, double share_1) {
  double all = 0.0;
  for (const int count : counts) all += count;
  if (all == 0.0) return std::nullopt;
  double below = 0.0;
  for (size_t level = 0; level < counts.size(); ++level) {
    below += counts[level];
    if (below >= share_1 * all) return static_cast<double>(level);
  }
  return 255.0;
}

bool Rise(double low, double aim, double high) { return 0.0 < low && low <= aim && aim <= high; }

}  // namespace

std::optional<std::string> ExposureOptions::Validate() const {
  if (!Rise(low_level_1, aim_level_1, high_level_1)) {
    return "levels of the target must keep 0 < low <= aim <= high";
  }
  if (!Rise(low_scene_level_1, aim_scene_level_1, high_scene_level_1)) {
    return "levels of the scene must keep 0 < low <= aim <= high";
  }
  if (!(high_level_1 < clipped_level_1 && high_scene_level_1 < clipped_level_1)) {
    return "clipped_level_1 must be above the levels to keep";
  }
  if (!(gamma_1 >= 1.0)) return "gamma_1 must be at least 1";
  if (!(clipped_step_1 > 0.0 && clipped_step_1 < 1.0))
    return "clipped_step_1 must be within 0 and 1";
  if (!(most_change_1 > 1.0)) return "most_change_1 must be above 1";
  if (!(0.0 < least_exposure_s && least_exposure_s < most_exposure_s)) {
    return "exposures must keep 0 < least_exposure_s < most_exposure_s";
  }
  return std::nullopt;
}

SeenLight MeasureLight(const sensor::Image& image, std::span<const uint8_t> target_mask) {
  const RgbImage pixels(image);
  Require(target_mask.empty() || target_mask.size() == static_cast<size_t>(image.width_px) *
                                                           static_cast<size_t>(image.height_px),
          "MeasureLight: the mask has not the image's size");
  if (!target_mask.empty()) {
    if (const auto level_1 = LevelOf(CountLevels(pixels, target_mask), 0.99)) {
      return {true, *level_1};
    }
  }
  return {false, *LevelOf(CountLevels(pixels, {}), 0.5)};
}

double NextExposure(double exposure_s, const SeenLight& seen, const ExposureOptions& options) {
  const std::optional<std::string> error = options.Validate();
  Require(!error, "ExposureOptions: " + error.value_or(""));
  Require(exposure_s > 0.0, "NextExposure: exposure_s must be positive");
  const double low_1 = seen.of_target ? options.low_level_1 : options.low_scene_level_1;
  const double aim_1 = seen.of_target ? options.aim_level_1 : options.aim_scene_level_1;
  const double high_1 = seen.of_target ? options.high_level_1 : options.high_scene_level_1;
  double change_1 = 1.0;
  if (seen.level_1 >= options.clipped_level_1) {
    change_1 = options.clipped_step_1;
  } else if (seen.level_1 < low_1 || seen.level_1 > high_1) {
    change_1 = std::pow(aim_1 / std::max(1.0, seen.level_1), options.gamma_1);
  }
  change_1 = std::clamp(change_1, 1.0 / options.most_change_1, options.most_change_1);
  return std::clamp(change_1 * exposure_s, options.least_exposure_s, options.most_exposure_s);
}

}  // namespace geon::attention
