#pragma once

#include <cstdint>
#include <vector>

#include "attention/color_model.h"

namespace geon::attention {

// A half-space in 16-bit arithmetic: with L the sum of coefficient * channel, a colour is in it
// when L > sure, is not when L <= maybe, and in between the double-precision rule must be asked.
// Seldom is there anything in between.
struct PlaneTest {
  int16_t coefficients[3] = {0, 0, 0};  // of red, green, blue
  int16_t sure = 0;
  int16_t maybe = 0;
};

// A region: bounds of each channel (what its half-spaces of one channel say), and the other planes.
struct RegionTest {
  uint8_t low[3] = {0, 0, 0};
  uint8_t high[3] = {255, 255, 255};
  bool bounded = false;           // whether the bounds leave anything out
  bool doubtful = false;          // whether any plane has sure != maybe
  std::vector<PlaneTest> planes;  // those that leave out most colours first
};

// The same region in whole numbers: together with the rule of HalfSpaceColor where in doubt, it
// decides every colour as that rule alone.
//
// Source: own. Planes of whole coefficients with magnitudes of at most 128 in sum are never in
// doubt (see WholeNumbered); for planes of two channels the smallest equivalent pair of
// coefficients is searched, as 25 b < 11 r - 1265 for equation 4.24 of the thesis.
RegionTest TestOf(const HalfSpaceColor& region);

}  // namespace geon::attention
