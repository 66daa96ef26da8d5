#include "active_vision/target_middle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace geon::active_vision {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// A stripe over a box, up its front and over its top, `across_m` beside its middle.
sensor::RangeProfile OverBox(const Vector2d& middle_m, double half_m, double high_m,
                             double across_m) {
  sensor::RangeProfile profile;
  const auto add = [&](double x_m, double z_m) {
    profile.pixel.push_back(static_cast<int>(profile.pixel.size()));
    profile.p_L_m.emplace_back(middle_m.x() + x_m, middle_m.y() + across_m, z_m);
  };
  for (double z_m = 0.0; z_m < high_m; z_m += 0.005) add(-half_m, z_m);
  for (double x_m = -half_m; x_m <= half_m; x_m += 0.005) add(x_m, high_m);
  return profile;
}

std::vector<sensor::RangeProfile> BoxScan(const Vector2d& middle_m, double half_m = 0.06,
                                          double high_m = 0.15) {
  std::vector<sensor::RangeProfile> profiles;
  for (const double side : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    profiles.push_back(OverBox(middle_m, half_m, high_m, side * half_m));
  }
  return profiles;
}

const Vector2d kBoxMiddle_m(1.05, 0.03);
const Vector2d kBoxFoot_m(1.10, 0.0);  // as it was believed

TEST(TargetMiddleTest, OfABoxItIsTheBoxesOwn) {
  const auto middle_m = TargetMiddle(BoxScan(kBoxMiddle_m), kBoxFoot_m);
  ASSERT_TRUE(middle_m.has_value());
  EXPECT_LT((*middle_m - kBoxMiddle_m).norm(), 0.01);
}

TEST(TargetMiddleTest, SupportWallAndOtherColoursDoNotPullIt) {
  auto profiles = BoxScan(kBoxMiddle_m);
  sensor::RangeProfile others;
  const auto add = [&](const Vector3d& p_m) {
    others.pixel.push_back(static_cast<int>(others.pixel.size()));
    others.p_L_m.push_back(p_m);
  };
  for (double y_m = -0.25; y_m < 0.0; y_m += 0.005) {
    add({0.95, y_m, 0.002});  // the support before it
    add({1.55, y_m, 0.4});    // a wall behind it
  }
  profiles.push_back(others);
  for (sensor::RangeProfile& profile : profiles) {
    profile.on_color_1.assign(profile.p_L_m.size(), 0.9);
  }
  sensor::RangeProfile grey;  // near, high enough, but not of its colour
  for (double y_m = -0.25; y_m < -0.1; y_m += 0.005) {
    grey.pixel.push_back(static_cast<int>(grey.pixel.size()));
    grey.p_L_m.emplace_back(1.0, y_m, 0.1);
    grey.on_color_1.push_back(0.1);
  }
  profiles.push_back(grey);
  const auto middle_m = TargetMiddle(profiles, kBoxFoot_m);
  ASSERT_TRUE(middle_m.has_value());
  EXPECT_LT((*middle_m - kBoxMiddle_m).norm(), 0.01);
}

TEST(TargetMiddleTest, AFewWrongPointsDoNotMoveIt) {
  auto profiles = BoxScan(kBoxMiddle_m);
  profiles[0].p_L_m[0] = {1.30, 0.2, 0.1};
  profiles[1].p_L_m[0] = {0.90, -0.2, 0.1};
  profiles[2].p_L_m[0] = {1.25, 0.22, 0.1};
  const auto middle_m = TargetMiddle(profiles, kBoxFoot_m);
  ASSERT_TRUE(middle_m.has_value());
  EXPECT_LT((*middle_m - kBoxMiddle_m).norm(), 0.02);
}

TEST(TargetMiddleTest, WithTooFewPointsThereIsNone) {
  EXPECT_FALSE(TargetMiddle({}, kBoxFoot_m).has_value());
  EXPECT_FALSE(TargetMiddle(BoxScan({2.0, 0.0}), kBoxFoot_m).has_value()) << "all too far off";
  sensor::RangeProfile few;
  for (int i = 0; i < 19; ++i) few.p_L_m.emplace_back(1.1, 0.001 * i, 0.1);
  EXPECT_FALSE(TargetMiddle(std::vector{few}, kBoxFoot_m).has_value());
  few.p_L_m.emplace_back(1.1, 0.019, 0.1);
  EXPECT_TRUE(TargetMiddle(std::vector{few}, kBoxFoot_m).has_value());
}

}  // namespace
}  // namespace geon::active_vision
