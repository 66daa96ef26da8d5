#include "mission/pose_history.h"

#include <gtest/gtest.h>

namespace geon::mission {
namespace {

constexpr int64_t kStart = 1'700'000'000'000'000;
constexpr int64_t kTick = 50'000;

sensor::BaseState BaseAt(int64_t utime, double x_m, double heading_rad) {
  sensor::BaseState state;
  state.utime = utime;
  state.status = sensor::DeviceStatus::kReady;
  state.x_m = x_m;
  state.heading_rad = heading_rad;
  return state;
}

sensor::PtuState PtuAt(int64_t utime, double pan_rad, bool moving) {
  sensor::PtuState state;
  state.utime = utime;
  state.status = sensor::DeviceStatus::kReady;
  state.pan_rad = pan_rad;
  state.moving = moving;
  return state;
}

TEST(PoseHistoryTest, InterpolatesTheRobotAcrossTheEndOfTheCircle) {
  PoseHistory history;
  history.Add(BaseAt(kStart, 0.0, 3.0));
  history.Add(BaseAt(kStart + kTick, 0.1, -3.0));
  const auto X_WR = history.RobotAt(kStart + kTick / 2);
  ASSERT_TRUE(X_WR.has_value());
  EXPECT_NEAR(X_WR->translation().x(), 0.05, 1e-12);
  EXPECT_NEAR(X_WR->linear()(0, 0), -1.0, 1e-9);
}

TEST(PoseHistoryTest, PosesAreWhereTheMapHasOdometry) {
  PoseHistory history;
  history.Add(BaseAt(kStart, 1.0, 0.0));
  history.Add(BaseAt(kStart + kTick, 2.0, 0.0));
  history.SetOdometryPose(geometry::PlanarPose(0.5, 0.0, 1.5707963267948966));
  const auto X_WR = history.RobotAt(kStart + kTick / 2);
  EXPECT_NEAR(X_WR->translation().x(), 0.5, 1e-9);
  EXPECT_NEAR(X_WR->translation().y(), 1.5, 1e-9);
  EXPECT_NEAR(X_WR->linear()(1, 0), 1.0, 1e-9);
}

TEST(PoseHistoryTest, KnowsNothingBeforeTheFirstAndLongAfterTheLast) {
  PoseHistory history;
  EXPECT_FALSE(history.RobotAt(kStart).has_value());
  history.Add(BaseAt(kStart, 0.0, 0.0));
  EXPECT_FALSE(history.RobotAt(kStart - 1).has_value());
  EXPECT_TRUE(history.RobotAt(kStart + 100'000).has_value());
  EXPECT_FALSE(history.RobotAt(kStart + 200'000).has_value());
}

TEST(PoseHistoryTest, AHeadThatMovedDuringTheExposureIsNotStill) {
  PoseHistory history;
  for (int i = 0; i < 4; ++i) history.Add(PtuAt(kStart + i * kTick, 0.3, false));
  const auto still = history.HeadAt(kStart + kTick / 2, 0.06, 0.001);
  ASSERT_TRUE(still.has_value());
  EXPECT_TRUE(still->still);
  EXPECT_NEAR(still->head.pan_rad, 0.3, 1e-12);
  history.Add(PtuAt(kStart + 4 * kTick, 0.31, true));
  EXPECT_FALSE(history.HeadAt(kStart + 3 * kTick + kTick / 2, 0.02, 0.001)->still);
}

TEST(PoseHistoryTest, AnExposureThatMayGoOnIsNotJudgedStill) {
  PoseHistory history;
  history.Add(PtuAt(kStart, 0.3, false));
  history.Add(PtuAt(kStart + kTick, 0.3, false));
  EXPECT_FALSE(history.HeadKnownAfter(kStart + 2 * kTick));
  EXPECT_FALSE(history.HeadAt(kStart + kTick / 2, 0.06, 0.001)->still);
}

TEST(PoseHistoryTest, AnUnknownPtuAndAClockThatJumpedBackStartAnew) {
  PoseHistory history;
  history.Add(PtuAt(kStart, 0.3, false));
  sensor::PtuState unknown = PtuAt(kStart + kTick, 0.3, false);
  unknown.status = sensor::DeviceStatus::kUnknown;
  history.Add(unknown);
  EXPECT_FALSE(history.HeadAt(kStart, 0.0, 0.001).has_value());
  history.Add(BaseAt(kStart, 1.0, 0.0));
  history.Add(BaseAt(kStart - 1'000'000, 2.0, 0.0));
  EXPECT_FALSE(history.RobotAt(kStart).has_value());
}

}  // namespace
}  // namespace geon::mission
