#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "sensor/image.h"

namespace geon::attention {

struct ExposureOptions {
  // The target's brightest hundredth is kept between these levels of its largest channel (red of a
  // red target) and brought to the middle one when it leaves them: below clipping, above the noise.
  double low_level_1 = 200.0;
  double aim_level_1 = 218.0;
  double high_level_1 = 235.0;
  // Without a target in view: the same of the median of the whole picture.
  double low_scene_level_1 = 105.0;
  double aim_scene_level_1 = 130.0;
  double high_scene_level_1 = 160.0;
  double gamma_1 = 2.2;            // of the camera: level = light to the power of 1 / gamma
  double clipped_level_1 = 250.0;  // at or above, the light may be any amount ...
  double clipped_step_1 = 0.4;     // ... and the exposure changes by this
  double most_change_1 = 4.0;      // of one step, either way
  double least_exposure_s = 0.0002;
  double most_exposure_s = 0.100;

  // What is wrong with the values; nothing when they are good.
  std::optional<std::string> Validate() const;
};

// How bright a picture is, as far as the exposure cares.
struct SeenLight {
  bool of_target = false;  // else of the whole picture
  double level_1 = 0.0;    // 0 ... 255
};

// The 99th percentile of the largest channel on the target (`target_mask`: width x height, non-zero
// on it), or where the mask is empty or all 0 the median over the picture. Input: kRgb8 or kBgr8.
SeenLight MeasureLight(const sensor::Image& image, std::span<const uint8_t> target_mask);

// The exposure for the frames to come, given what one taken with `exposure_s` shows. The same
// again while the level is where it should be: a step must be worth the frames it costs.
//
// Source: own; the thesis's camera had its exposure set by hand (4.1.2 reports what sunlight did).
double NextExposure(double exposure_s, const SeenLight& seen, const ExposureOptions& options);

}  // namespace geon::attention
