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
  int dark_level = 20;      // pixels whose largest channel is below carry no colour
  int clipped_level = 250;  // pixels with a channel at or above have lost it
  int min_samples = 100;    // fewer usable pixels of the target are refused
  // To take a share of the background is as bad as to miss so many times that share of the target.
  double background_weight_1 = 3.0;
  // Share of the background that may have any colour whatever: what no picture shows yet.
  double unseen_1 = 0.1;
  // What a simpler and wider model may cost, as a share of the target.
  double tolerance_1 = 0.003;

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

// Learns a colour model from samples: the polygon of chromaticity, as a cone of planes through
// black, that tells the target best from everything else in the pictures. Every picture counts the
// same, however large its target is. Dark and clipped pixels are not learned from; the model says
// "cannot tell" of them.
//
//   1. Histograms of chromaticity of either side, a bin smoothed with its neighbours.
//   2. What a bin is worth: its share of the target less background_weight_1 times its share of the
//      background. Positive is where a Bayes ratio of the two would say target.
//   3. The polygon of the greatest worth (fit_color_region.h). A box that holds some background
//      teaches the same: there the background's share is the greater one.
//
// Source: thesis 4.1.2 picks thresholds by hand from the colour histogram of a taught object; here
// both sides are counted. Deviation: planes through black, so that the model holds when the light
// changes in strength. Fails when too few usable pixels are given, or no colour marks the target.
Result<LearnedColor> LearnColorModel(const std::vector<TeachingSample>& samples,
                                     const std::string& name, const TeachingOptions& options = {});

}  // namespace geon::attention
