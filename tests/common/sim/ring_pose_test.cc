#include "sim/ring_pose.h"

#include <gtest/gtest.h>

namespace geon::sim {
namespace {

constexpr double kRadius_m = 0.225, kHeight_m = 0.55;

TEST(RingPoseTest, SensorsCountCounterClockwiseFromTheBearing) {
  RingPose pose;
  pose.center_W_m = {1.0, 2.0};
  pose.bearing_W_rad = kPi / 2;
  const auto X_WS = RingSensorPose(pose, 4, 16, kRadius_m, kHeight_m);
  EXPECT_LT((X_WS.translation() - Eigen::Vector3d(1.0 - kRadius_m, 2.0, kHeight_m)).norm(), 1e-12);
  EXPECT_LT((X_WS.linear().col(0) + Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((X_WS.linear().col(2) - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(RingPoseTest, ATiltedRobotLowersTheSensorsOnOneSideAndLetsThemLookDown) {
  const double tilt_rad = RadiansFromDegrees(2.0);
  RingPose pose;
  pose.rotation_W = geometry::RotationAboutY(tilt_rad);  // nose down
  const auto ahead = RingSensorPose(pose, 0, 16, kRadius_m, kHeight_m);
  const auto behind = RingSensorPose(pose, 8, 16, kRadius_m, kHeight_m);
  EXPECT_NEAR(ahead.translation().z(),
              kHeight_m * std::cos(tilt_rad) - kRadius_m * std::sin(tilt_rad), 1e-12);
  EXPECT_NEAR(behind.translation().z() - ahead.translation().z(),
              2.0 * kRadius_m * std::sin(tilt_rad), 1e-12);
  EXPECT_NEAR(ahead.linear()(2, 0), -std::sin(tilt_rad), 1e-12);
  EXPECT_NEAR(behind.linear()(2, 0), std::sin(tilt_rad), 1e-12);
}

}  // namespace
}  // namespace geon::sim
