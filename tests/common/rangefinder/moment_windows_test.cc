#include "rangefinder/moment_windows.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geon::rangefinder {
namespace {

TEST(MomentWindowsTest, WeightsAreAGaussianAndItsMoments) {
  for (const float sigma_px : {0.8F, 2.0F, 5.0F, 9.5F}) {
    for (const bool on_pixel : {true, false}) {
      const MomentWindow& window = WindowFor(sigma_px, on_pixel);
      EXPECT_NEAR(window.sigma_px, sigma_px, 0.1 * sigma_px);
      EXPECT_EQ(window.pixels % 2, on_pixel ? 1 : 0);
      EXPECT_LE(window.pixels, kMostWindowPixels);
      EXPECT_NEAR(window.sum[1], 0.0, 1e-6);
      // Within the window of 2.5 standard deviations.
      EXPECT_NEAR(window.sum[0], std::sqrt(2.0 * std::acos(-1.0)) * window.sigma_px,
                  0.02 * window.sum[0]);
    }
  }
}

TEST(MomentWindowsTest, ARunTellsTheWidth) {
  // A Gaussian of 2 px is above 1/8 of its height for 8.2 px.
  EXPECT_NEAR(SigmaOfRun(8, 8.0F), 2.0, 0.1);
}

}  // namespace
}  // namespace geon::rangefinder
