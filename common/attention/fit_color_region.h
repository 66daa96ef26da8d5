#pragma once

#include <Eigen/Core>

#include "attention/color_model.h"

namespace geon::attention {

// Colours without their brightness: the shares of red (row) and of green (column) in the sum of the
// channels, each in kChromaticityBins steps.
inline constexpr int kChromaticityBins = 128;
struct ChromaticityBin {
  int red = 0;
  int green = 0;
};
ChromaticityBin BinOf(const Rgb& pixel);  // not for black

struct FittedRegion {
  HalfSpaceColor region;
  double worth_1 = 0.0;  // sum over the bins inside
};

// The convex polygon of chromaticity that holds the greatest sum of `worth_1` (kChromaticityBins
// squared; positive where a colour is wanted, negative where it is not), as half-spaces through
// black with whole coefficients. Few sides and wide ones: a side whose removal costs at most
// `tolerance_1` goes, and each side is pushed outward as far as that costs no more.
//
// Source: own; after Tosas and Mills (2007), who place such planes by hand. Sides have 16 fixed
// directions. From no sides, and from sides close round what is wanted, the one side is moved whose
// best place gains most, until none gains; the better end counts. It need not be the best polygon.
// No half-spaces when no cut gains anything.
FittedRegion FitColorRegion(const Eigen::ArrayXXd& worth_1, double tolerance_1);

}  // namespace geon::attention
