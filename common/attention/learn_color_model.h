#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "attention/color_model.h"
#include "base/status.h"
#include "sensor/image.h"

namespace geon::attention {

struct TeachingOptions {
  double min_luminance_1 = 12.0;  // darker samples carry no colour
  int clipped_level = 250;        // pixels with a channel at or above are not learned from
  int min_samples = 100;          // fewer usable pixels of the target are refused
  // Rim of the ellipse, as Mahalanobis distance: the best one between these is taken.
  double min_reach_1 = 1.5;
  double max_reach_1 = 4.0;
  // Standard deviation of chromaticity that a camera's noise has at least.
  double noise_floor_1 = 0.02;

  // What is wrong with the values; nothing when they are good.
  std::optional<std::string> Validate() const;
};

// One picture of the teacher: which pixels are the target, everything else being background.
struct TeachingSample {
  sensor::Image image;             // kRgb8 or kBgr8
  std::vector<uint8_t> is_target;  // width x height, non-zero on the target
};

// What the teacher should know before trusting the model. Shares are of the samples, 0 ... 1.
struct TeachingReport {
  int target_pixels = 0;
  int background_pixels = 0;
  double recall_1 = 0.0;            // of the target's pixels the model takes
  double precision_1 = 0.0;         // of the model's pixels that are target
  double clipped_fraction_1 = 0.0;  // of the target's pixels
  Hsi mean_color;                   // of the taught colour
  std::vector<std::string> warnings;
};

struct LearnedColor {
  ColorModel model;
  TeachingReport report;
};

// Learns a colour model from samples: the ellipse of the target's chromaticity, as large as tells
// it best from everything else in the pictures.
//
// Source: thesis 4.1.2 picks thresholds by hand from the colour histogram of a taught object; here
// the rim is found by counting both sides. Deviation: in chrominance over luminance (4.4-4.6), so
// that the model holds when the light changes in strength; the ellipse becomes a cone of planes
// through black. Fails when too few usable pixels are
// given, or none of the colour is told apart from the background.
Result<LearnedColor> LearnColorModel(const std::vector<TeachingSample>& samples,
                                     const std::string& name, const TeachingOptions& options = {});

}  // namespace geon::attention
