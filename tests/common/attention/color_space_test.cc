#include "attention/color_space.h"

#include <gtest/gtest.h>

#include "base/angles.h"

namespace geon::attention {
namespace {

TEST(ColorSpaceTest, WhiteHasLuminanceAndNoChrominance) {
  const Yiq yiq = YiqFromRgb({255, 255, 255});
  EXPECT_NEAR(yiq.luminance_1, 255.0, 1e-9);
  EXPECT_NEAR(yiq.in_phase_1, 0.0, 1e-9);
  EXPECT_NEAR(yiq.quadrature_1, 0.0, 1e-9);
}

TEST(ColorSpaceTest, YiqWeighsRedBlueGreenInThePrintedOrder) {
  const Yiq blue = YiqFromRgb({0, 0, 100});
  EXPECT_NEAR(blue.luminance_1, 11.4, 1e-9);
  EXPECT_NEAR(blue.in_phase_1, -32.2, 1e-9);
  EXPECT_NEAR(blue.quadrature_1, 31.2, 1e-9);
}

TEST(ColorSpaceTest, HueTurnsFromRedOverGreenToBlue) {
  EXPECT_NEAR(HsiFromRgb({200, 0, 0}).hue_rad, 0.0, 1e-12);
  EXPECT_NEAR(HsiFromRgb({0, 200, 0}).hue_rad, RadiansFromDegrees(120), 1e-12);
  EXPECT_NEAR(HsiFromRgb({0, 0, 200}).hue_rad, RadiansFromDegrees(-120), 1e-12);
}

TEST(ColorSpaceTest, SaturationIsOneForPureColorsAndZeroForGreysAndBlack) {
  EXPECT_NEAR(HsiFromRgb({130, 60, 0}).saturation_1, 1.0, 1e-12);
  EXPECT_NEAR(HsiFromRgb({90, 90, 90}).saturation_1, 0.0, 1e-12);
  EXPECT_EQ(HsiFromRgb({0, 0, 0}).saturation_1, 0.0);
  EXPECT_NEAR(HsiFromRgb({30, 60, 90}).intensity_1, 60.0, 1e-12);
}

}  // namespace
}  // namespace geon::attention
