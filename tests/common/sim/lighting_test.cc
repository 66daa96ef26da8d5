#include "sim/lighting.h"

#include <gtest/gtest.h>

namespace geon::sim {
namespace {

TEST(LightingTest, WhiteBalanceMakesTheLampWhite) {
  EXPECT_TRUE(BlackBodyColor(4000.0).isApprox(Eigen::Vector3f::Ones()));
}

TEST(LightingTest, BulbsAreRedderAndDaylightIsBluer) {
  const Eigen::Vector3f bulb = BlackBodyColor(2700.0), daylight = BlackBodyColor(6500.0);
  EXPECT_GT(bulb[0], 1.2F);
  EXPECT_LT(bulb[2], 0.6F);
  EXPECT_LT(daylight[0], 0.9F);
  EXPECT_GT(daylight[2], 1.3F);
}

}  // namespace
}  // namespace geon::sim
