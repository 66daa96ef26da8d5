#include "recognition/stripe_crossings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/common/recognition/surface_view.h"

namespace geon::recognition {
namespace {

TEST(FindCrossings, MeetsOnTheSurfaceWithItsNormalTowardsTheCamera) {
  const double slope = 0.5;
  const CrossingGrid grid =
      FindCrossings(ViewOfSurface([&](double, double z_m) { return -slope * z_m; }));
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) {
      ASSERT_TRUE(grid[row][column].has_value());
      const Crossing& crossing = *grid[row][column];
      EXPECT_NEAR(crossing.p_L_m.y(), 0.05 * (1.0 - static_cast<double>(column)), 0.005);
      EXPECT_NEAR(crossing.p_L_m.z(), 0.5 + 0.05 * (1.0 - static_cast<double>(row)), 0.005);
      EXPECT_LT(crossing.normal_L.x(), 0.0);
      EXPECT_NEAR(crossing.normal_L.z() / -crossing.normal_L.x(), slope, 1e-3);
      EXPECT_NEAR((crossing.normal_L - crossing.face_normal_L).norm(), 0.0, 1e-3);
    }
  }
}

TEST(FindCrossings, LeavesOutStripesThatDoNotMeet) {
  TargetView view = ViewOfSurface([](double, double) { return 0.0; });
  view.stripes[0].p_L_m.resize(60);  // ends before the second vertical stripe
  view.stripes[0].curve_m.resize(60);
  view.stripes[0].tangent_B_1.resize(60);
  view.stripes[5] = TargetStripe();
  const CrossingGrid grid = FindCrossings(view);
  EXPECT_TRUE(grid[0][0].has_value());
  EXPECT_FALSE(grid[0][1].has_value());
  EXPECT_TRUE(grid[1][1].has_value());
  EXPECT_FALSE(grid[1][2].has_value());
}

}  // namespace
}  // namespace geon::recognition
