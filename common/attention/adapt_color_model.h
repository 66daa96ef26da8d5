#pragma once

#include <optional>

#include "attention/color_model.h"
#include "sensor/image.h"

namespace geon::attention {

// What the colour of the light does to red and blue, green taken as 1: factors of pixel values, 1
// under the light that a colour is stated for.
struct LightGain {
  double red_1 = 1.0;
  double blue_1 = 1.0;
};

// The gain by which a picture shows a surface of known colour, such as the floor: the medians of
// red over green and of blue over green, against `known`. Dark and clipped pixels are left out.
// Input: kRgb8 or kBgr8, filled mostly by that surface. Nothing when fewer than a tenth of the
// pixels can be used.
std::optional<LightGain> MeasureLightGain(const sensor::Image& image, const Rgb& known);

// The picture as the light of gain 1 would show it: for teaching.
sensor::Image UnderNeutralLight(const sensor::Image& image, const LightGain& gain);

// A model made for gain 1, for pictures taken under `gain`: the gain goes into the coefficients, no
// pixel is touched. Exact for planes through black, up to their rounding to whole numbers; levels
// and thresholds stay.
//
// Source: von Kries's diagonal model of adaptation; cameras raise light to a power, which leaves a
// gain a gain.
ColorModel AdaptColorModel(const ColorModel& model, const LightGain& gain);

}  // namespace geon::attention
