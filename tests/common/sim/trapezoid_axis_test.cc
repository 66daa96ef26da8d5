#include "sim/trapezoid_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace geon::sim {
namespace {

constexpr double kAxisStep_s = 0.001;

double TimeToStand(TrapezoidAxis* axis, double limit_s = 60.0) {
  double time_s = 0.0;
  while (axis->moving() && time_s < limit_s) {
    axis->Step(kAxisStep_s);
    time_s += kAxisStep_s;
  }
  return time_s;
}

TEST(TrapezoidAxis, TakesTheTimeOfATrapezoidalProfile) {
  TrapezoidAxis axis;
  axis.MoveTo(1000.0, 500.0, 1000.0);
  // 0.5 s up over 125, 750 at full speed for 1.5 s, 0.5 s down over 125.
  EXPECT_NEAR(TimeToStand(&axis), 2.5, 0.01);
  EXPECT_EQ(axis.position(), 1000.0);
}

TEST(TrapezoidAxis, AShortMoveNeverReachesItsSpeed) {
  TrapezoidAxis axis;
  axis.MoveTo(10.0, 500.0, 1000.0);
  double fastest = 0.0;
  for (int i = 0; i < 500; ++i) {
    axis.Step(kAxisStep_s);
    fastest = std::max(fastest, axis.velocity());
  }
  EXPECT_EQ(axis.position(), 10.0);
  EXPECT_NEAR(fastest, std::sqrt(1000.0 * 10.0), 3.0);
}

TEST(TrapezoidAxis, ReversesInMidMotionWithoutAJump) {
  TrapezoidAxis axis;
  axis.MoveTo(1000.0, 400.0, 800.0);
  for (int i = 0; i < 1000; ++i) axis.Step(kAxisStep_s);
  axis.MoveTo(-200.0, 400.0, 800.0);
  double before = axis.velocity();
  while (axis.moving()) {
    axis.Step(kAxisStep_s);
    if (!axis.moving()) break;
    EXPECT_LE(std::abs(axis.velocity() - before), 0.81);
    before = axis.velocity();
  }
  EXPECT_EQ(axis.position(), -200.0);
}

TEST(TrapezoidAxis, AStepperJumpsToItsStartSpeed) {
  TrapezoidAxis axis;
  axis.set_start_speed(100.0);
  axis.MoveTo(1000.0, 300.0, 500.0);
  axis.Step(kAxisStep_s);
  EXPECT_NEAR(axis.velocity(), 100.0, 1.0);
  TimeToStand(&axis);
  EXPECT_EQ(axis.position(), 1000.0);
}

TEST(TrapezoidAxis, RunsAtAVelocityUntilToldOtherwise) {
  TrapezoidAxis axis;
  axis.RunAt(-2.0, 4.0);
  for (int i = 0; i < 2000; ++i) axis.Step(kAxisStep_s);
  EXPECT_NEAR(axis.velocity(), -2.0, 1e-9);
  EXPECT_NEAR(axis.position(), -(0.5 + 1.5 * 2.0), 0.01);
  axis.RunAt(0.0, 4.0);
  EXPECT_NEAR(TimeToStand(&axis), 0.5, 0.01);
}

TEST(TrapezoidAxis, ATargetMovesAlongWhenThePositionIsRedefined) {
  TrapezoidAxis axis;
  axis.MoveTo(10.0, 5.0, 50.0);
  axis.Step(kAxisStep_s);
  axis.Redefine(100.0);
  TimeToStand(&axis);
  EXPECT_NEAR(axis.position(), 110.0, 0.01);
}

TEST(TrapezoidAxis, AnObstructedMoveGoesOnFromWhereItIsLeft) {
  TrapezoidAxis axis;
  axis.MoveTo(1.0, 1.0, 1.0);
  for (int i = 0; i < 500; ++i) {
    axis.Step(kAxisStep_s);
    axis.Obstruct(0.1, 0.0);
  }
  EXPECT_TRUE(axis.moving());
  TimeToStand(&axis);
  EXPECT_EQ(axis.position(), 1.0);
}

}  // namespace
}  // namespace geon::sim
