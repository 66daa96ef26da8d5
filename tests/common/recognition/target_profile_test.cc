#include "recognition/target_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/rigid_transform.h"
#include "recognition/profile_noise.h"

namespace geon::recognition {
namespace {

// A camera one metre up that looks along x; a horizontal stripe on a wall two metres away, 1 mm
// from pixel to pixel, from y = 0.1 to the right.
sensor::ScanSet WallScan() {
  sensor::ScanSet scan;
  scan.camera_position_L_m = {0.0, 0.0, 1.0};
  scan.rotation_LB = geometry::CameraAxesInBody();
  sensor::RangeProfile profile;
  profile.laser = sensor::Laser::kHorizontal;
  for (int i = 0; i < 200; ++i) {
    profile.pixel.push_back(i);
    profile.p_L_m.emplace_back(2.0, 0.1 - 0.001 * i, 0.8);
  }
  scan.profiles.push_back(profile);
  return scan;
}

TargetProfile Find(const sensor::ScanSet& scan, const std::optional<VerticalRegion>& region = {},
                   const SmoothingOptions& smoothing = {}) {
  return FindTargetProfile(scan.profiles[0], scan, region, smoothing, {}, {});
}

TEST(FindTargetProfile, IsTheSameAsItsStagesOneAfterTheOther) {
  sensor::ScanSet scan = WallScan();
  for (size_t i = 0; i < 200; ++i) {
    scan.profiles[0].p_L_m[i].x() += 0.002 * std::sin(17.0 * static_cast<double>(i));
    if (i >= 80) scan.profiles[0].p_L_m[i].x() += 0.2;
    if (i >= 40) scan.profiles[0].pixel[i] += 2;
  }
  const VerticalRegion region{-0.025, 0.035};
  for (Smoothing kind : {Smoothing::kNone, Smoothing::kMedian, Smoothing::kGaussian}) {
    SmoothingOptions smoothing;
    smoothing.kind = kind;
    const sensor::RangeProfile& profile = scan.profiles[0];
    const auto depth_m = ProfileDepths(profile.p_L_m, scan.camera_position_L_m, scan.rotation_LB);
    auto p_L_m =
        MoveAlongRays(profile.p_L_m, depth_m, SmoothDepths(profile.pixel, depth_m, smoothing),
                      scan.camera_position_L_m);
    DropBackground(scan, region, {}, &p_L_m);
    const TargetProfile target = Find(scan, region, smoothing);
    EXPECT_EQ(target.p_L_m, p_L_m);
    EXPECT_EQ(target.segments.size(), FindSegments(p_L_m, {}).size());
  }
}

TEST(FindTargetProfile, SplitsWhereTheTargetDoesNotHangTogether) {
  sensor::ScanSet scan = WallScan();
  for (size_t i = 120; i < 200; ++i) scan.profiles[0].p_L_m[i].x() += 0.3;
  const TargetProfile target = Find(scan);
  ASSERT_EQ(target.segments.size(), 2U);
  EXPECT_EQ(target.segments[0].end, 120U);
  EXPECT_EQ(target.first_L(), target.p_L_m.front());
  EXPECT_EQ(target.last_L(), target.p_L_m.back());
}

TEST(FindTargetProfile, HasNoSegmentsWhenAllIsFloor) {
  sensor::ScanSet scan = WallScan();
  for (Eigen::Vector3d& p_L : scan.profiles[0].p_L_m) p_L.z() = 0.005;
  EXPECT_TRUE(Find(scan).segments.empty());
}

TEST(FindTargetProfile, LooksAlongTheStripesOwnRotation) {
  sensor::ScanSet scan = WallScan();
  EXPECT_EQ(Find(scan).rotation_LB, scan.rotation_LB);
  scan.profiles[0].rotation_LB = geometry::RotationAboutZ(0.1) * scan.rotation_LB;
  EXPECT_EQ(Find(scan).rotation_LB, *scan.profiles[0].rotation_LB);
}

}  // namespace
}  // namespace geon::recognition
