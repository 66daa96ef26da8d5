#include "recognition/region_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/rigid_transform.h"
#include "tests/common/recognition/wall_scan.h"

namespace geon::recognition {
namespace {

// A wall, whose fourth point lies behind the camera.
sensor::ScanSet WallWithAPointBehind() {
  sensor::ScanSet scan = WallScan(41, 0.2, 0.01);
  scan.profiles[0].p_L_m[3].x() = -2.0;
  scan.profiles[0].fraction = 0.25;
  return scan;
}

TEST(FindRegionProfile, KeepsWhatLiesBetweenTheTwoPlanes) {
  const sensor::ScanSet scan = WallWithAPointBehind();
  const RegionProfile part =
      FindRegionProfile(scan.profiles[0], scan, VerticalRegion{-0.0525, 0.02});
  ASSERT_EQ(part.pixel.size(), 15U);  // tangents of -0.05 to 0.02
  EXPECT_EQ(part.pixel.front(), 10);
  EXPECT_EQ(part.pixel.back(), 24);
  EXPECT_EQ(part.p_L_m.front(), scan.profiles[0].p_L_m[10]);
  EXPECT_EQ(part.p_L_m.size(), part.pixel.size());
  EXPECT_EQ(part.depth_m, std::vector<double>(15, 2.0));
  EXPECT_EQ(part.laser, sensor::Laser::kHorizontal);
  EXPECT_EQ(part.fraction, 0.25);
}

TEST(FindRegionProfile, KeepsAllBeforeTheCameraWhereThereIsNoRegion) {
  const sensor::ScanSet scan = WallWithAPointBehind();
  const RegionProfile part = FindRegionProfile(scan.profiles[0], scan, std::nullopt);
  EXPECT_EQ(part.pixel.size(), 40U);
  EXPECT_EQ(part.pixel[3], 4);
}

TEST(FindRegionProfile, MeasuresDepthsInTheCameraAsItStoodAtTheStripe) {
  sensor::ScanSet scan = WallWithAPointBehind();
  scan.profiles[0].rotation_LB = geometry::RotationAboutZ(0.1) * scan.rotation_LB;
  const RegionProfile part = FindRegionProfile(scan.profiles[0], scan, std::nullopt);
  EXPECT_EQ(part.camera.R_LB, *scan.profiles[0].rotation_LB);
  EXPECT_NEAR(part.depth_m[0], 2.0 * std::cos(0.1) + 0.2 * std::sin(0.1), 1e-12);
}

TEST(FindRegionProfiles, GivesOneForEachProfile) {
  sensor::ScanSet scan = WallWithAPointBehind();
  scan.profiles.emplace_back();
  const auto parts = FindRegionProfiles(scan, std::nullopt);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_TRUE(parts[1].pixel.empty());
  EXPECT_EQ(parts[1].noise_m, 0.0);
}

}  // namespace
}  // namespace geon::recognition
