#include "recognition/target_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/rigid_transform.h"
#include "tests/common/recognition/wall_scan.h"

namespace geon::recognition {
namespace {

TargetProfile Find(const sensor::ScanSet& scan, Smoothing kind = Smoothing::kMedian) {
  SmoothingOptions smoothing;
  smoothing.kind = kind;
  return FindTargetProfile(FindRegionProfiles(scan, std::nullopt)[0], smoothing, {}, {});
}

TEST(FindTargetProfile, SmoothsDepthsAlongTheViewingRays) {
  sensor::ScanSet scan = WallScan(200, 0.1, 0.001);
  const Eigen::Vector3d& p_LB_m = scan.camera_position_L_m;
  for (size_t i = 0; i < 200; ++i) {
    scan.profiles[0].p_L_m[i].x() += 0.002 * std::sin(17.0 * static_cast<double>(i));
  }
  const RegionProfile part = FindRegionProfiles(scan, std::nullopt)[0];
  for (Smoothing kind : {Smoothing::kNone, Smoothing::kMedian, Smoothing::kGaussian}) {
    SmoothingOptions smoothing;
    smoothing.kind = kind;
    const auto smooth_m = SmoothDepths(part.pixel, part.depth_m, smoothing);
    const TargetProfile target = Find(scan, kind);
    ASSERT_EQ(target.p_L_m.size(), 200U);
    for (size_t i = 0; i < 200; ++i) {
      const Eigen::Vector3d ray = target.p_L_m[i] - p_LB_m;
      EXPECT_NEAR(ray.x(), smooth_m[i], 1e-12);
      EXPECT_NEAR(ray.cross(part.p_L_m[i] - p_LB_m).norm(), 0.0, 1e-12);
    }
  }
}

TEST(FindTargetProfile, SplitsWhereTheTargetDoesNotHangTogether) {
  sensor::ScanSet scan = WallScan(200, 0.1, 0.001);
  for (size_t i = 120; i < 200; ++i) scan.profiles[0].p_L_m[i].x() += 0.3;
  const TargetProfile target = Find(scan);
  ASSERT_EQ(target.segments.size(), 2U);
  EXPECT_EQ(target.segments[0].end, 120U);
  EXPECT_EQ(target.first_L(), target.p_L_m.front());
  EXPECT_EQ(target.last_L(), target.p_L_m.back());
}

TEST(FindTargetProfile, HasNoSegmentsWhenAllIsFloor) {
  sensor::ScanSet scan = WallScan(200, 0.1, 0.001);
  for (Eigen::Vector3d& p_L : scan.profiles[0].p_L_m) p_L.z() = 0.005;
  EXPECT_TRUE(Find(scan).segments.empty());
}

TEST(FindTargetProfile, LooksAlongTheStripesOwnRotation) {
  sensor::ScanSet scan = WallScan(200, 0.1, 0.001);
  EXPECT_EQ(Find(scan).R_LB, scan.rotation_LB);
  scan.profiles[0].rotation_LB = geometry::RotationAboutZ(0.1) * scan.rotation_LB;
  EXPECT_EQ(Find(scan).R_LB, *scan.profiles[0].rotation_LB);
}

}  // namespace
}  // namespace geon::recognition
