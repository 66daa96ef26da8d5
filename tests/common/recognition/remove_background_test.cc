#include "recognition/remove_background.h"

#include <gtest/gtest.h>

#include "base/contracts.h"
#include "geometry/rigid_transform.h"

namespace geon::recognition {
namespace {

constexpr double kFocal_px = 1600.0;
constexpr double kCentre_px = 319.5;

// A camera 1 m high that looks along x, and a horizontal stripe on a wall 1 m ahead.
sensor::ScanSet WallScan(const sensor::PixelBox& box) {
  sensor::ScanSet scan;
  scan.camera_position_L_m = {0, 0, 1};
  scan.rotation_LB = geometry::CameraAxesInBody();
  scan.target_box = box;
  sensor::RangeProfile profile;
  for (int u_px = 100; u_px < 540; u_px += 4) {
    profile.pixel.push_back(u_px);
    profile.p_L_m.emplace_back(1.0, -(u_px - kCentre_px) / kFocal_px, 0.9);
  }
  scan.profiles.push_back(profile);
  return scan;
}

TEST(RemoveBackground, KeepsTheColumnsOfTheTargetBoxAndAMargin) {
  const auto scan = WallScan({200, 100, 120, 100});
  BackgroundOptions options;
  options.margin_px = 10;
  const auto target = RemoveBackground(
      scan.profiles[0],
      TestTargetPoints(scan.profiles[0], scan, FindVerticalRegion(scan, options), options));
  ASSERT_FALSE(target.pixel.empty());
  EXPECT_EQ(target.pixel.front(), 192);
  EXPECT_EQ(target.pixel.back(), 328);
  EXPECT_EQ(target.on_target, static_cast<int32_t>(target.pixel.size()));
  EXPECT_EQ(target.p_L_m.size(), target.pixel.size());
}

TEST(RemoveBackground, TheRegionHoldsForVerticalStripesOfAPannedHead) {
  const auto scan = WallScan({200, 100, 120, 100});
  const auto region = FindVerticalRegion(scan, {});
  sensor::RangeProfile vertical;
  vertical.laser = sensor::Laser::kVertical;
  vertical.rotation_LB = geometry::RotationAboutZ(0.2) * scan.rotation_LB;
  vertical.pixel = {10, 11};
  vertical.p_L_m = {{1.0, -(250 - kCentre_px) / kFocal_px, 0.5},
                    {1.0, -(400 - kCentre_px) / kFocal_px, 0.5}};
  EXPECT_EQ(TestTargetPoints(vertical, scan, region, {}), (std::vector<bool>{true, false}));
}

TEST(RemoveBackground, DropsPointsLowerThanACentimetreAboveTheFloor) {
  auto scan = WallScan({0, 0, 640, 480});
  scan.profiles[0].pixel = {300, 301, 302};
  scan.profiles[0].p_L_m = {{1, 0, 0.02}, {1, 0, 0.0099}, {1, 0, -0.3}};
  EXPECT_EQ(TestTargetPoints(scan.profiles[0], scan, std::nullopt, {}),
            (std::vector<bool>{true, false, false}));
}

TEST(RemoveBackground, KnowsNoRegionWithoutABoxOrWithoutHorizontalStripes) {
  auto scan = WallScan({200, 100, 120, 100});
  scan.profiles[0].laser = sensor::Laser::kVertical;
  EXPECT_FALSE(FindVerticalRegion(scan, {}).has_value());
  scan.profiles[0].laser = sensor::Laser::kHorizontal;
  EXPECT_TRUE(FindVerticalRegion(scan, {}).has_value());
  scan.target_box.reset();
  EXPECT_FALSE(FindVerticalRegion(scan, {}).has_value());
}

TEST(RemoveBackground, KeepsTheColoursOfWhatItKeeps) {
  sensor::RangeProfile profile;
  profile.pixel = {4, 5, 6};
  profile.p_L_m.assign(3, Eigen::Vector3d::UnitX());
  profile.on_color_1 = {0.1, 0.2, 0.3};
  const auto target = RemoveBackground(profile, {true, false, true});
  EXPECT_EQ(target.pixel, (std::vector<int>{4, 6}));
  EXPECT_EQ(target.on_color_1, (std::vector<double>{0.1, 0.3}));
  EXPECT_THROW(RemoveBackground(profile, {true}), ContractViolation);
}

TEST(RemoveBackground, RefusesANegativeMargin) {
  BackgroundOptions options;
  options.margin_px = -1;
  EXPECT_THROW(options.Validate(), ContractViolation);
}

}  // namespace
}  // namespace geon::recognition
