#include "sim/ptu_unit.h"

#include <gtest/gtest.h>

#include "base/angles.h"

namespace geon::sim {
namespace {

std::string PassUnit(PtuUnit* unit, double duration_s) {
  std::string events;
  for (double t_s = 0.0; t_s < duration_s; t_s += 0.001) events += unit->Step(0.001);
  return events;
}

TEST(PtuUnit, ACountIsAboutAFiftiethOfADegree) {
  PtuUnit unit({});
  unit.MoveTo(PtuAxisId::kPan, 1000);
  unit.MoveTo(PtuAxisId::kTilt, -900);
  PassUnit(&unit, 3.0);
  EXPECT_NEAR(DegreesFromRadians(unit.shaft_rad(PtuAxisId::kPan)), 51.4286, 1e-3);
  EXPECT_NEAR(DegreesFromRadians(unit.shaft_rad(PtuAxisId::kTilt)), -46.2857, 1e-3);
}

TEST(PtuUnit, AResetHuntsEachStopTiltFirstAndComesHome) {
  PtuUnit unit({});
  unit.axis(PtuAxisId::kPan).LoseSteps(250);
  EXPECT_EQ(PassUnit(&unit, 0.01), "!P");
  unit.StartReset({true, true});
  EXPECT_TRUE(unit.resetting());
  EXPECT_EQ(PassUnit(&unit, 25.0), "!T!T!P!P");
  EXPECT_FALSE(unit.resetting());
  EXPECT_EQ(unit.axis(PtuAxisId::kPan).position(), 0);
  EXPECT_EQ(unit.shaft_rad(PtuAxisId::kPan), 0.0);
}

TEST(PtuUnit, AResetOfOneAxisLeavesTheOther) {
  PtuUnit unit({});
  unit.MoveTo(PtuAxisId::kTilt, 300);
  PassUnit(&unit, 2.0);
  unit.StartReset({true, false});
  EXPECT_EQ(PassUnit(&unit, 20.0), "!P!P");
  EXPECT_EQ(unit.axis(PtuAxisId::kTilt).position(), 300);
}

TEST(PtuUnit, SlavedMovesStartTogetherWhenTold) {
  PtuUnit unit({});
  unit.settings().immediate = false;
  unit.MoveTo(PtuAxisId::kPan, 500);
  PassUnit(&unit, 1.0);
  EXPECT_FALSE(unit.moving());
  EXPECT_EQ(unit.Target(PtuAxisId::kPan), 500);
  unit.StartPendingMoves();
  PassUnit(&unit, 2.0);
  EXPECT_EQ(unit.axis(PtuAxisId::kPan).position(), 500);
}

TEST(PtuUnit, MonitorGoesToAndFroUntilAborted) {
  PtuUnit unit({});
  unit.settings().monitor_a = {-100, -50};
  unit.settings().monitor_b = {100, 50};
  unit.StartMonitor();
  double lowest = 0.0;
  double highest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    unit.Step(0.001);
    lowest = std::min(lowest, unit.axis(PtuAxisId::kPan).position());
    highest = std::max(highest, unit.axis(PtuAxisId::kPan).position());
  }
  EXPECT_EQ(lowest, -100);
  EXPECT_EQ(highest, 100);
  unit.AbortMonitor();
  PassUnit(&unit, 2.0);
  EXPECT_EQ(unit.axis(PtuAxisId::kPan).position(), 0);
  EXPECT_EQ(unit.axis(PtuAxisId::kTilt).position(), 0);
}

TEST(PtuUnit, PowerBringsBackWhatWasSaved) {
  PtuUnit unit({});
  unit.axis_settings(PtuAxisId::kPan).speed = 700;
  unit.settings().reset_at_power_up = {false, false};
  unit.Save();
  unit.axis_settings(PtuAxisId::kPan).speed = 900;
  unit.echo = unit.verbose = false;
  unit.PowerCycle();
  EXPECT_EQ(unit.axis_settings(PtuAxisId::kPan).speed, 700);
  EXPECT_TRUE(unit.echo && unit.verbose);
  PassUnit(&unit, 0.01);
  EXPECT_FALSE(unit.resetting());
  unit.Restore(true);
  EXPECT_EQ(unit.axis_settings(PtuAxisId::kPan).speed, 1000);
}

}  // namespace
}  // namespace geon::sim
