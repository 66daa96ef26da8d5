#include "active_vision/head_angles.h"

#include <gtest/gtest.h>

namespace geon::active_vision {
namespace {

TEST(HeadLimitsTest, ClampBringsBothAxesInside) {
  const HeadLimits limits{-1.0, 1.0, -0.5, 0.25};
  EXPECT_EQ(limits.Clamp({2.0, -0.75}), (HeadAngles{1.0, -0.5}));
  EXPECT_EQ(limits.Clamp({-0.5, 0.125}), (HeadAngles{-0.5, 0.125}));
  EXPECT_TRUE(limits.Contain({1.0, 0.25}));
  EXPECT_FALSE(limits.Contain({1.0, 0.26}));
  EXPECT_FALSE(limits.Contain({-1.01, 0.0}));
}

}  // namespace
}  // namespace geon::active_vision
