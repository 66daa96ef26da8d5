#include "recognition/target_extent.h"

#include <gtest/gtest.h>

#include "tests/common/recognition/wall_scan.h"

namespace geon::recognition {
namespace {

TEST(FindRows, GoesThroughTheHorizontalStripes) {
  sensor::ScanSet scan;
  for (const double fraction : {0.25, 0.5, 0.75}) {
    sensor::ScanSet one = WallScan(9, 0.0, 0.001);
    one.profiles[0].fraction = fraction;
    for (Eigen::Vector3d& p_m : one.profiles[0].p_L_m) p_m.z() = 1.0 - 0.2 * fraction;
    scan.camera_position_L_m = one.camera_position_L_m;
    scan.rotation_LB = one.rotation_LB;
    scan.profiles.push_back(one.profiles[0]);
  }
  const auto rows = FindRows(FindRegionProfiles(scan, std::nullopt), CameraAtTarget(scan));
  ASSERT_TRUE(rows.has_value());
  EXPECT_NEAR(rows->first_1, 0.0, 1e-9);
  EXPECT_NEAR(rows->last_1, 0.1, 1e-9);  // 0.2 m at 2 m
  EXPECT_TRUE(rows->Holds(0.104, 0.05));
  EXPECT_FALSE(rows->Holds(0.106, 0.05));
  scan.profiles.resize(1);
  EXPECT_FALSE(FindRows(FindRegionProfiles(scan, std::nullopt), CameraAtTarget(scan)).has_value());
}

TEST(FindColumns, AreTheRegionWithoutItsMargin) {
  sensor::ScanSet scan;
  scan.target_box = sensor::PixelBox{100, 0, 101, 10};
  const auto columns = FindColumns(scan, VerticalRegion{-0.1, 0.5}, 10);  // 120 px wide
  ASSERT_TRUE(columns.has_value());
  EXPECT_NEAR(columns->first_1, -0.05, 1e-9);
  EXPECT_NEAR(columns->last_1, 0.45, 1e-9);
  EXPECT_FALSE(FindColumns(scan, std::nullopt, 10).has_value());
}

}  // namespace
}  // namespace geon::recognition
