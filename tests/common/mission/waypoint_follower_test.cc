#include "mission/waypoint_follower.h"

#include <gtest/gtest.h>

namespace geon::mission {
namespace {

class WaypointFollowerTest : public testing::Test {
 protected:
  static constexpr double kTick_s = 0.05;
  navigation::DriveVelocity Go(const Eigen::Vector2d& waypoint_R_m) {
    now_s_ += kTick_s;
    return follower_.Go(now_s_, waypoint_R_m, {}, options_);
  }
  double GoFor(int steps) {
    double speed_m_s = 0.0;
    for (int i = 0; i < steps; ++i) speed_m_s = Go(far_m_).speed_m_s;
    return speed_m_s;
  }
  // What the speed may grow by in a step.
  double gentle_m_s() const { return options_.acceleration_m_s2 * kTick_s + 1e-9; }

  navigation::VelocityLawOptions options_;
  WaypointFollower follower_;
  Eigen::Vector2d far_m_{4.0, 0.0};
  double now_s_ = 50.0;
};

TEST_F(WaypointFollowerTest, SpeedGrowsGentlyToItsLimit) {
  double speed_m_s = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double next_m_s = Go(far_m_).speed_m_s;
    EXPECT_LE(next_m_s, speed_m_s + gentle_m_s()) << i;
    EXPECT_GE(next_m_s, speed_m_s) << i;
    speed_m_s = next_m_s;
  }
  EXPECT_NEAR(speed_m_s, options_.max_speed_m_s, 1e-9);
}

TEST_F(WaypointFollowerTest, AtItsOwnPlaceItStandsAndThenStartsAnew) {
  EXPECT_GT(GoFor(20), 0.2);
  const auto standing = Go({0.0, 0.0});
  EXPECT_EQ(standing.speed_m_s, 0.0);
  EXPECT_EQ(standing.turn_rate_rad_s, 0.0);
  EXPECT_EQ(follower_.waypoint_R_m(), Eigen::Vector2d(0.0, 0.0));
  EXPECT_LE(Go(far_m_).speed_m_s, gentle_m_s());
}

TEST_F(WaypointFollowerTest, RestForgetsSpeedAndWaypoint) {
  EXPECT_GT(GoFor(20), 0.2);
  EXPECT_EQ(follower_.waypoint_R_m(), far_m_);
  follower_.Rest();
  EXPECT_EQ(follower_.waypoint_R_m(), Eigen::Vector2d(0.0, 0.0));
  now_s_ += 10.0;
  EXPECT_LE(Go(far_m_).speed_m_s, gentle_m_s());
  EXPECT_LE(Go(far_m_).speed_m_s, 2.0 * gentle_m_s());
}

TEST_F(WaypointFollowerTest, ALongPauseDoesNotAllowAJumpOfSpeed) {
  const double before_m_s = GoFor(5);
  now_s_ += 30.0;
  EXPECT_LE(Go(far_m_).speed_m_s, before_m_s + 5.0 * gentle_m_s());
}

TEST_F(WaypointFollowerTest, AClockThatStandsStillDoesNotSpeedItUp) {
  const double before_m_s = GoFor(5);
  now_s_ -= kTick_s;
  EXPECT_NEAR(Go(far_m_).speed_m_s, before_m_s, 1e-9);
}

TEST_F(WaypointFollowerTest, ItTurnsToAWaypointAsideAndDrivesGentlyFromThere) {
  EXPECT_GT(GoFor(20), 0.2);
  const auto turning = Go({0.0, 2.0});
  EXPECT_EQ(turning.speed_m_s, 0.0);
  EXPECT_GT(turning.turn_rate_rad_s, 0.0);
  EXPECT_LE(Go(far_m_).speed_m_s, gentle_m_s());
}

TEST_F(WaypointFollowerTest, WhatStandsAheadStopsIt) {
  EXPECT_GT(GoFor(20), 0.2);
  const std::vector<Eigen::Vector2d> obstacles_R_m = {{options_.body_radius_m + 0.01, 0.0}};
  EXPECT_EQ(follower_.Go(now_s_ + kTick_s, far_m_, obstacles_R_m, options_).speed_m_s, 0.0);
}

}  // namespace
}  // namespace geon::mission
