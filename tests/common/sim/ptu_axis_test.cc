#include "sim/ptu_axis.h"

#include <gtest/gtest.h>

namespace geon::sim {
namespace {

PtuAxis Pan() { return PtuAxis(-3090, 3090, 30); }

void PassAxis(PtuAxis* axis, double duration_s) {
  for (double t_s = 0.0; t_s < duration_s; t_s += 0.001) axis->Step(0.001);
}

TEST(PtuAxis, ReachesItsTargetAndStands) {
  PtuAxis axis = Pan();
  axis.MoveTo(1500);
  PassAxis(&axis, 3.0);
  EXPECT_EQ(axis.position(), 1500);
  EXPECT_EQ(axis.shaft(), 1500);
  EXPECT_FALSE(axis.moving());
  EXPECT_FALSE(axis.TakeLimitHit());
}

TEST(PtuAxis, TheCounterRunsOnWhenTheShaftMeetsItsStop) {
  PtuAxis axis = Pan();
  axis.MoveTo(3500);
  PassAxis(&axis, 6.0);
  EXPECT_EQ(axis.position(), 3500);
  EXPECT_EQ(axis.shaft(), 3120);
  EXPECT_TRUE(axis.TakeLimitHit());
  EXPECT_FALSE(axis.TakeLimitHit()) << "once for each hit";
  axis.MoveTo(0);
  PassAxis(&axis, 6.0);
  EXPECT_EQ(axis.shaft(), -380) << "the counter lies";
}

TEST(PtuAxis, HuntingAndReferencingMakeTheCounterTrueAgain) {
  PtuAxis axis = Pan();
  axis.LoseSteps(400);
  EXPECT_TRUE(axis.TakeLimitHit());
  axis.HuntStop(true, 1500);
  PassAxis(&axis, 6.0);
  EXPECT_FALSE(axis.hunting());
  EXPECT_EQ(axis.shaft(), 3120);
  axis.Reference();
  EXPECT_EQ(axis.position(), 3120);
  EXPECT_FALSE(axis.moving());
}

TEST(PtuAxis, RunsTowardsABoundAndStopsThere) {
  PtuAxis axis = Pan();
  axis.RunTowardsBound(-2000, true);
  PassAxis(&axis, 0.5);
  EXPECT_LT(axis.velocity(), -500);
  PassAxis(&axis, 6.0);
  EXPECT_EQ(axis.position(), -3090);
  EXPECT_FALSE(axis.TakeLimitHit());
  axis.RunTowardsBound(-2000, false);
  PassAxis(&axis, 2.0);
  EXPECT_EQ(axis.shaft(), -3120);
  EXPECT_TRUE(axis.TakeLimitHit());
}

TEST(PtuAxis, HaltsWithItsOwnDeceleration) {
  PtuAxis axis = Pan();
  axis.MoveTo(3000);
  PassAxis(&axis, 1.0);
  const double before = axis.position();
  axis.Halt();
  PassAxis(&axis, 1.0);
  EXPECT_FALSE(axis.moving());
  EXPECT_NEAR(axis.position() - before, 1000.0 * 1000.0 / 2.0 / 2000.0, 10.0);
  EXPECT_EQ(axis.target(), axis.position());
}

TEST(PtuAxis, SpeedChangesOnTheFly) {
  PtuAxis axis = Pan();
  axis.MoveTo(3000);
  PassAxis(&axis, 1.0);
  axis.settings.speed = 200;
  axis.ChangeSpeed();
  PassAxis(&axis, 0.6);
  EXPECT_NEAR(axis.velocity(), 200, 1.0);
  EXPECT_EQ(axis.target(), 3000);
}

TEST(PtuAxis, SwitchedOnWithoutAResetItTakesItsPlaceForZero) {
  PtuAxis axis = Pan();
  axis.MoveTo(700);
  PassAxis(&axis, 3.0);
  axis.ForgetPosition();
  EXPECT_EQ(axis.position(), 0);
  EXPECT_EQ(axis.shaft(), 700);
}

}  // namespace
}  // namespace geon::sim
