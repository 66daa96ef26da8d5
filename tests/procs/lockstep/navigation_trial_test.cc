#include "procs/lockstep/navigation_trial.h"

#include <gtest/gtest.h>

#include "config/daemon_arguments.h"
#include "sim/random_pen.h"

namespace geon::lockstep {
namespace {

class NavigationTrialTest : public testing::Test {
 protected:
  LockstepSettings Settings(SensorQuality quality, mission::PlannerKind planner) const {
    LockstepSettings settings = ForNavigation(*loaded_, quality);
    settings.mission.driving.planner = planner;
    return settings;
  }
  static NavigationOutcome Run(const LockstepSettings& settings, sim::PenKind kind, uint64_t seed) {
    const auto outcome = RunNavigationTrial(settings, sim::RandomPen(seed, kind), seed, 120.0);
    EXPECT_TRUE(outcome.ok()) << outcome.message();
    return outcome.ok() ? *outcome : NavigationOutcome();
  }
  const Result<LockstepSettings> loaded_ =
      LoadLockstepSettings(config::InstalledFile("scripts/config/robot.yaml"),
                           config::InstalledFile("scripts/config/sim.yaml"));
};

TEST_F(NavigationTrialTest, ByTheMapEveryKindOfPenEndsAsItShould) {
  using sim::PenKind;
  const LockstepSettings settings = Settings(SensorQuality::kReal, mission::PlannerKind::kMap);
  for (const PenKind kind : {PenKind::kBoxes, PenKind::kUTrap, PenKind::kDeadEnd, PenKind::kGap}) {
    SCOPED_TRACE(sim::ToString(kind));
    const NavigationOutcome outcome = Run(settings, kind, 11);
    EXPECT_EQ(outcome.end, NavigationEnd::kReached) << outcome.why;
    EXPECT_EQ(outcome.track.contacts, 0);
    ASSERT_TRUE(outcome.track.first_sight_s.has_value());
    EXPECT_LT(*outcome.track.first_sight_s, outcome.end_s);
    EXPECT_GT(outcome.track.path_m, 0.3);
  }
  const NavigationOutcome closed = Run(settings, PenKind::kUnreachable, 11);
  EXPECT_EQ(closed.end, NavigationEnd::kUnreachable) << closed.why;
  const NavigationOutcome empty = Run(settings, PenKind::kEmpty, 11);
  EXPECT_EQ(empty.end, NavigationEnd::kNoneFound) << empty.why;
  EXPECT_FALSE(empty.track.first_sight_s.has_value());
}

TEST_F(NavigationTrialTest, TheThesissRuleIsTrappedWhereTheMapIsNot) {
  const auto end = [&](mission::PlannerKind planner) {
    return Run(Settings(SensorQuality::kReal, planner), sim::PenKind::kUTrap, 3).end;
  };
  EXPECT_EQ(end(mission::PlannerKind::kMap), NavigationEnd::kReached);
  EXPECT_EQ(end(mission::PlannerKind::kThesis), NavigationEnd::kTrapped);
}

TEST_F(NavigationTrialTest, WithPerfectOrWithDegradedSensorsItIsReachedToo) {
  for (const SensorQuality quality : {SensorQuality::kPerfect, SensorQuality::kDegraded}) {
    SCOPED_TRACE(ToString(quality));
    const auto outcome =
        Run(Settings(quality, mission::PlannerKind::kMap), sim::PenKind::kBoxes, 5);
    EXPECT_EQ(outcome.end, NavigationEnd::kReached) << outcome.why;
  }
}

TEST_F(NavigationTrialTest, WithADestinationTheRunEndsThere) {
  sim::World world;
  world.pen_size_m = {3.0, 6.0};
  world.robot_x_m = 1.0;
  world.robot_y_m = 1.0;
  world.robot_heading_rad = M_PI / 2.0;
  for (const double x_m : {0.9, 1.1, 1.3}) {
    sim::WorldObject object;
    object.shape = sim::CylinderShape{0.1, 0.65};
    object.x_m = x_m;
    object.y_m = 3.0;
    world.objects.push_back(object);
  }
  for (const SensorQuality quality : {SensorQuality::kPerfect, SensorQuality::kReal}) {
    SCOPED_TRACE(ToString(quality));
    LockstepSettings settings = Settings(quality, mission::PlannerKind::kMap);
    settings.mission.destination_W_m = Eigen::Vector2d(4.0, 0.0);  // the way up the pen
    const auto outcome = RunNavigationTrial(settings, world, 1, 120.0);
    ASSERT_TRUE(outcome.ok()) << outcome.message();
    EXPECT_EQ(outcome->end, NavigationEnd::kReached) << outcome->why;
    EXPECT_LT(outcome->left_m.value(), 0.25);
    EXPECT_GT(outcome->track.path_m + *outcome->left_m, 4.0);
    EXPECT_LT(outcome->track.path_m, 5.5);
    EXPECT_EQ(outcome->track.contacts, 0);
    EXPECT_FALSE(outcome->track.first_sight_s.has_value());
    settings.mission.destination_W_m = Eigen::Vector2d(4.0, 3.0);  // beyond the boards
    EXPECT_EQ(RunNavigationTrial(settings, world, 1, 200.0)->end, NavigationEnd::kUnreachable);
  }
}

TEST_F(NavigationTrialTest, FramesThatNeverArriveShowNothingByGlancesEither) {
  LockstepSettings settings = Settings(SensorQuality::kReal, mission::PlannerKind::kMap);
  const sim::World pen = sim::RandomPen(5, sim::PenKind::kBoxes);
  const auto sight_s = [&] {
    return RunNavigationTrial(settings, pen, 5, 20.0)->track.first_sight_s;
  };
  EXPECT_TRUE(sight_s().has_value());
  settings.sim.renderer.color.dropped_1 = settings.sim.renderer.floor.dropped_1 = 1.0;
  EXPECT_FALSE(sight_s().has_value());
}

TEST_F(NavigationTrialTest, TheSameSeedGivesTheSamePath) {
  const LockstepSettings settings = Settings(SensorQuality::kReal, mission::PlannerKind::kMap);
  const NavigationOutcome once = Run(settings, sim::PenKind::kGap, 8);
  const NavigationOutcome again = Run(settings, sim::PenKind::kGap, 8);
  EXPECT_EQ(once.track.path_W_m, again.track.path_W_m);
  EXPECT_EQ(once.end_s, again.end_s);
}

TEST(NavigationNamesTest, NamesLeadBackToTheirValues) {
  for (const SensorQuality quality :
       {SensorQuality::kPerfect, SensorQuality::kReal, SensorQuality::kDegraded}) {
    EXPECT_EQ(SensorQualityFromString(ToString(quality)), quality);
  }
  for (const NavigationEnd end : {NavigationEnd::kReached, NavigationEnd::kUnreachable,
                                  NavigationEnd::kNoneFound, NavigationEnd::kTrapped}) {
    EXPECT_EQ(NavigationEndFromString(ToString(end)), end);
  }
  EXPECT_FALSE(SensorQualityFromString("good").has_value());
}

}  // namespace
}  // namespace geon::lockstep
