#include "recognition/region_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/rigid_transform.h"

namespace geon::recognition {
namespace {

// A camera at (0, 0, 1) that looks along x, and a horizontal stripe on a wall 2 m ahead, from 0.2 m
// left of the middle to 0.2 m right of it; the fourth point lies behind the camera.
sensor::ScanSet WallScan() {
  sensor::ScanSet scan;
  scan.camera_position_L_m = {0.0, 0.0, 1.0};
  scan.rotation_LB = geometry::CameraAxesInBody();
  sensor::RangeProfile profile;
  profile.laser = sensor::Laser::kHorizontal;
  profile.fraction = 0.25;
  for (int i = 0; i <= 40; ++i) {
    profile.pixel.push_back(100 + i);
    profile.p_L_m.emplace_back(i == 3 ? -2.0 : 2.0, 0.2 - 0.01 * i, 0.8);
  }
  scan.profiles.push_back(profile);
  return scan;
}

TEST(FindRegionProfile, KeepsWhatLiesBetweenTheTwoPlanes) {
  const sensor::ScanSet scan = WallScan();
  const RegionProfile part =
      FindRegionProfile(scan.profiles[0], scan, VerticalRegion{-0.0525, 0.02});
  ASSERT_EQ(part.pixel.size(), 15U);  // tangents of -0.05 to 0.02
  EXPECT_EQ(part.pixel.front(), 110);
  EXPECT_EQ(part.pixel.back(), 124);
  EXPECT_EQ(part.p_L_m.front(), scan.profiles[0].p_L_m[10]);
  EXPECT_EQ(part.p_L_m.size(), part.pixel.size());
  EXPECT_EQ(part.depth_m, std::vector<double>(15, 2.0));
  EXPECT_EQ(part.laser, sensor::Laser::kHorizontal);
  EXPECT_EQ(part.fraction, 0.25);
}

TEST(FindRegionProfile, KeepsAllBeforeTheCameraWhereThereIsNoRegion) {
  const sensor::ScanSet scan = WallScan();
  const RegionProfile part = FindRegionProfile(scan.profiles[0], scan, std::nullopt);
  EXPECT_EQ(part.pixel.size(), 40U);
  EXPECT_EQ(part.pixel[3], 104);
}

TEST(FindRegionProfile, MeasuresDepthsInTheCameraAsItStoodAtTheStripe) {
  sensor::ScanSet scan = WallScan();
  scan.profiles[0].rotation_LB = geometry::RotationAboutZ(0.1) * scan.rotation_LB;
  const RegionProfile part = FindRegionProfile(scan.profiles[0], scan, std::nullopt);
  EXPECT_EQ(part.camera.R_LB, *scan.profiles[0].rotation_LB);
  EXPECT_NEAR(part.depth_m[0], 2.0 * std::cos(0.1) + 0.2 * std::sin(0.1), 1e-12);
}

TEST(FindRegionProfiles, GivesOneForEachProfile) {
  sensor::ScanSet scan = WallScan();
  scan.profiles.emplace_back();
  const auto parts = FindRegionProfiles(scan, std::nullopt);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_TRUE(parts[1].pixel.empty());
  EXPECT_EQ(parts[1].noise_m, 0.0);
}

}  // namespace
}  // namespace geon::recognition
