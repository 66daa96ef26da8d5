#include "sim/material.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geon::sim {
namespace {

TEST(MaterialTest, PaintIsSeenInItsColour) {
  const Material paint = Paint({150, 40, 40});
  EXPECT_NEAR(255.0 * std::pow(static_cast<double>(paint.color_1[0]), 1 / kGamma_1), 150.0, 0.1);
  EXPECT_NEAR(255.0 * std::pow(static_cast<double>(paint.color_1[2]), 1 / kGamma_1), 40.0, 0.1);
}

TEST(MaterialTest, RedAnswersTheLaserBest) {
  const float red = Paint({150, 40, 40}).laser_reflectance_1;
  EXPECT_GT(red, Paint({150, 150, 150}).laser_reflectance_1);
  EXPECT_GT(red, Paint({40, 40, 150}).laser_reflectance_1);
  EXPECT_LE(Paint({255, 0, 0}).laser_reflectance_1, 1.0F);
}

TEST(MaterialTest, StatedReflectanceWins) {
  EXPECT_FLOAT_EQ(Paint({150, 40, 40}, 0.07).laser_reflectance_1, 0.07F);
}

}  // namespace
}  // namespace geon::sim
