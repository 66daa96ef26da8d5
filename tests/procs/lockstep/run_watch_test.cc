#include "procs/lockstep/run_watch.h"

#include <gtest/gtest.h>

#include "procs/lockstep/lockstep_robot.h"

namespace geon::lockstep {
namespace {

constexpr double kTurn_s = LockstepRobot::kTurn_s;

sim::RobotTruth Driving(double x_m, double speed_m_s, int contacts) {
  sim::RobotTruth truth;
  truth.x_m = x_m;
  truth.speed_m_s = speed_m_s;
  truth.contacts = contacts;
  return truth;
}

TEST(RunWatchTest, AContactCountsOnceWhileItLastsWithTheSpeedBeforeIt) {
  RunWatch watch;
  watch.See(0.0, false, Driving(0.0, 0.3, 0));
  for (int k = 1; k < 5; ++k) watch.See(k * kTurn_s, false, Driving(0.0, 0.0, 2));
  watch.See(5 * kTurn_s, false, Driving(0.0, -0.1, 0));
  watch.See(6 * kTurn_s, false, Driving(0.0, 0.0, 1));
  EXPECT_EQ(watch.track().contacts, 2);
  EXPECT_DOUBLE_EQ(watch.track().hardest_contact_m_s, 0.3);
}

TEST(RunWatchTest, ThePathIsMeasuredForwardAndBackAndKeptFiveTimesASecond) {
  RunWatch watch;
  for (int k = 0; k < 400; ++k) {
    watch.See(k * kTurn_s, false, Driving(1e-3 * k, k < 200 ? 0.2 : -0.2, 0));
  }
  EXPECT_NEAR(watch.track().path_m, 0.4, 1e-9);
  ASSERT_EQ(watch.track().path_W_m.size(), 10U);
  EXPECT_NEAR(watch.track().path_W_m[1].x(), 0.04, 1e-9);
}

TEST(RunWatchTest, TheFirstSightIsKept) {
  RunWatch watch;
  watch.See(1.0, false, {});
  EXPECT_FALSE(watch.track().first_sight_s.has_value());
  watch.See(2.0, true, {});
  watch.See(3.0, false, {});
  watch.See(4.0, true, {});
  EXPECT_EQ(watch.track().first_sight_s, 2.0);
}

}  // namespace
}  // namespace geon::lockstep
