#include "recognition/support_plane.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/angles.h"
#include "recognition/target_extent.h"
#include "tests/common/recognition/synthetic_geons.h"

namespace geon::recognition {
namespace {

sensor::ScanSet ScanOnFloor() { return *ScanOfGeon(PlainGeons()[0], 0.3, {}, 1); }

std::optional<SupportPlane> FitTo(const sensor::ScanSet& scan) {
  const auto region = FindVerticalRegion(scan, {});
  const auto parts = FindRegionProfiles(scan, region);
  const auto rows = FindRows(parts, CameraAtTarget(scan));
  return FitSupportPlane(FindStripeBlocks(scan, region, parts, rows));
}

// The scan as a robot reports it whose level frame leans by `lean_rad` and lies `low_m` too low.
sensor::ScanSet Misjudged(const sensor::ScanSet& scan, double lean_rad, double low_m) {
  const Eigen::AngleAxisd turn(lean_rad, Eigen::Vector3d(0.6, 0.8, 0.0));
  const Eigen::Vector3d foot(1.0, 0.0, 0.0);
  sensor::ScanSet wrong = scan;
  const auto move = [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(turn * (p - foot) + foot + Eigen::Vector3d(0.0, 0.0, low_m));
  };
  wrong.camera_position_L_m = move(scan.camera_position_L_m);
  wrong.rotation_LB = turn * scan.rotation_LB;
  for (sensor::RangeProfile& profile : wrong.profiles) {
    for (Eigen::Vector3d& p_m : profile.p_L_m) p_m = move(p_m);
    if (profile.rotation_LB) profile.rotation_LB = turn * *profile.rotation_LB;
  }
  return wrong;
}

TEST(FitSupportPlane, FindsThePlaneThatTheScanStandsOn) {
  const double lean_rad = RadiansFromDegrees(3.0);
  const sensor::ScanSet wrong = Misjudged(ScanOnFloor(), lean_rad, 0.005);
  const auto plane = FitTo(wrong);
  ASSERT_TRUE(plane.has_value());
  EXPECT_NEAR(std::acos(plane->normal_L.z()), lean_rad, RadiansFromDegrees(0.3));
  EXPECT_LT(plane->sigma_m, 0.004);
  EXPECT_GE(plane->points, 40);
}

// The robot leans about its own foot: at the target that is 55 mm of height.
TEST(FitSupportPlane, FindsASupportFarBelowWhereItIsBelievedToBe) {
  const double lean_rad = RadiansFromDegrees(3.0);
  const sensor::ScanSet wrong = Misjudged(ScanOnFloor(), lean_rad, -0.055);
  const auto plane = FitTo(wrong);
  ASSERT_TRUE(plane.has_value());
  EXPECT_NEAR(std::acos(plane->normal_L.z()), lean_rad, RadiansFromDegrees(0.3));
  EXPECT_NEAR(plane->Above({1.0, 0.0, -0.055}), 0.0, 0.002);
}

// A level line on the wall behind, far below a support that is hardly seen.
TEST(FitSupportPlane, IsNotMisledByALineThatPassesFarBelowTheTarget) {
  std::vector<StripeBlock> blocks;
  const auto add = [&](const Eigen::Vector3d& p_L_m, BlockPlace place) {
    blocks.push_back({p_L_m, {0.0, 1.0, 0.0}, 0.001, 8, place});
  };
  for (int k = 0; k < 40; ++k) add({3.6, 0.05 * k - 1.0, -0.31}, BlockPlace::kBeside);
  for (int k = 0; k < 6; ++k) add({1.8, 0.01 * k, 0.0}, BlockPlace::kAtFoot);
  const auto misled = FitSupportPlane(blocks);
  ASSERT_TRUE(misled.has_value());
  EXPECT_GT(misled->Above({1.9, 0.0, 0.0}), 0.1);
  const auto plane = FitSupportPlane(blocks, Eigen::Vector3d(1.9, 0.0, 0.02));
  ASSERT_TRUE(plane.has_value());
  EXPECT_NEAR(plane->Above({1.9, 0.0, 0.0}), 0.0, 0.005);
}

// A desk whose edge is just before the target: what its front shows is no support.
TEST(FitSupportPlane, IsNotMisledByAFlatTopOrASteepFront) {
  std::vector<StripeBlock> blocks;
  const auto add = [&](const Eigen::Vector3d& p_L_m, const Eigen::Vector3d& along_L) {
    blocks.push_back({p_L_m, along_L, 0.001, 8, BlockPlace::kAtFoot});
  };
  for (int k = 0; k < 6; ++k) add({0.9, 0.05 * k - 0.125, 0.001 * (k % 2)}, {0.0, 1.0, 0.0});
  for (int k = 0; k < 40; ++k) add({0.88, 0.0, -0.003 * k}, {0.0, 0.0, -1.0});
  for (int k = 0; k < 40; ++k) add({1.0, 0.005 * k - 0.1, 0.05}, {0.0, 1.0, 0.0});
  const auto plane = FitSupportPlane(blocks);
  ASSERT_TRUE(plane.has_value());
  EXPECT_NEAR(plane->Above({0.9, 0.0, 0.0}), 0.0, 0.002);
}

TEST(FitSupportPlane, LeavesALevelSupportWhereItIs) {
  const sensor::ScanSet scan = ScanOnFloor();
  const auto plane = FitTo(scan);
  ASSERT_TRUE(plane.has_value());
  EXPECT_LT(std::acos(plane->normal_L.z()), RadiansFromDegrees(0.2));
  EXPECT_LT(std::abs(plane->p_L_m.z()), 0.001);
}

TEST(FitSupportPlane, FindsNoneWhereTheSupportWasCutAway) {
  sensor::ScanSet scan = ScanOnFloor();
  for (sensor::RangeProfile& profile : scan.profiles) {
    sensor::RangeProfile kept = profile;
    kept.pixel.clear();
    kept.p_L_m.clear();
    for (size_t i = 0; i < profile.p_L_m.size(); ++i) {
      if (profile.p_L_m[i].z() < 0.03) continue;
      kept.pixel.push_back(profile.pixel[i]);
      kept.p_L_m.push_back(profile.p_L_m[i]);
    }
    profile = kept;
  }
  EXPECT_FALSE(FitTo(scan).has_value());
  EXPECT_FALSE(FitTo({}).has_value());
}

TEST(LevelOn, UndoesTheMisjudgement) {
  const sensor::ScanSet scan = ScanOnFloor();
  const sensor::ScanSet wrong = Misjudged(scan, RadiansFromDegrees(3.0), 0.005);
  const geometry::RigidTransform level = LevelOn(*FitTo(wrong));
  for (size_t k = 0; k < scan.profiles.size(); ++k) {
    for (size_t i = 0; i < scan.profiles[k].p_L_m.size(); ++i) {
      EXPECT_NEAR((level * wrong.profiles[k].p_L_m[i]).z(), scan.profiles[k].p_L_m[i].z(), 0.004);
    }
  }
  EXPECT_LT((level.linear() * wrong.rotation_LB - scan.rotation_LB).norm(), 0.02);
}

}  // namespace
}  // namespace geon::recognition
