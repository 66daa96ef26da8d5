#include "mission/travel_phase.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

using testing::HasSubstr;

const Eigen::Vector2d kDestination_m(2.0, -1.0);

MissionOptions Sent(PlannerKind planner = PlannerKind::kMap) {
  MissionOptions options = FastOptions();
  options.driving.planner = planner;
  options.destination_W_m = kDestination_m;
  return options;
}

TEST(TravelPhaseTest, DrivesToTheDestinationFirstAndThenLooksForTheGeon) {
  for (const PlannerKind planner : {PlannerKind::kMap, PlannerKind::kThesis}) {
    SCOPED_TRACE(ToString(planner));
    FakeWorld world(Sent(planner));
    world.blocks[0].center_W_m = {3.2, 1.2};
    ASSERT_TRUE(world.RunUntil(Phase::kTravel, 5.0));
    ASSERT_TRUE(world.RunUntil(Phase::kSearch, 60.0)) << world.Text();
    EXPECT_LT((world.pose.head<2>() - kDestination_m).norm(), 0.12);
    ASSERT_TRUE(world.RunToTheEnd());
    EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
    EXPECT_FALSE(world.Touches());
  }
}

TEST(TravelPhaseTest, AGeonOnTheWayDoesNotStopIt) {
  FakeWorld world(Sent());
  world.blocks[0].center_W_m = {2.9, 0.3};
  ASSERT_TRUE(world.RunUntil([&] { return world.mission().phase() != Phase::kWait; }, 5.0));
  ASSERT_TRUE(world.RunUntil([&] { return world.mission().phase() != Phase::kTravel; }, 60.0));
  EXPECT_EQ(world.mission().phase(), Phase::kSearch) << world.Text();
  EXPECT_LT((world.pose.head<2>() - kDestination_m).norm(), 0.12);
}

TEST(TravelPhaseTest, AfterAContactItDrivesOn) {
  FakeWorld world(Sent());
  ASSERT_TRUE(world.RunUntil([&] { return world.wishes().velocity.speed_m_s > 0.2; }, 30.0));
  world.bumper_pressed = true;
  world.bumper_bearing_rad = 2.8;  // behind: it moves ahead
  ASSERT_TRUE(world.RunUntil(Phase::kBackOff, 0.2));
  world.bumper_pressed = false;
  ASSERT_TRUE(world.RunUntil([&] { return world.mission().phase() != Phase::kBackOff; }, 20.0));
  EXPECT_EQ(world.mission().phase(), Phase::kTravel);
}

TEST(TravelPhaseTest, ADestinationThatIsClosedInIsUnreachableAndNoGeonIsMadeUp) {
  FakeWorld world(Sent());
  world.target_hidden = true;
  world.Fence(kDestination_m, 0.6);
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kUnreachable) << world.Text();
  EXPECT_THAT(world.Text(), HasSubstr("unreachable"));
  EXPECT_TRUE(world.mission().State().findings.empty());
  EXPECT_FALSE(world.Touches());
}

}  // namespace
}  // namespace geon::mission
