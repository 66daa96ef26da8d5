#include "mission/rule_drive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

using testing::HasSubstr;

MissionOptions ByTheRule() {
  MissionOptions options = FastOptions();
  options.driving.planner = PlannerKind::kThesis;
  options.destination_W_m = Eigen::Vector2d(3.0, 0.0);
  options.patience.traps = 1;
  return options;
}

TEST(RuleDriveTest, OnFreeFloorItNeverWanders) {
  FakeWorld world(ByTheRule());
  world.target_hidden = true;
  ASSERT_TRUE(world.RunUntil(Phase::kTravel, 5.0));
  ASSERT_TRUE(world.RunUntil(
      [&] {
        EXPECT_EQ(world.Text().find("trapped"), std::string::npos) << world.Text();
        return world.mission().phase() == Phase::kSearch;
      },
      30.0))
      << world.Text();
}

TEST(RuleDriveTest, TrappedItWandersAndAtLastGivesUp) {
  FakeWorld world(ByTheRule());
  world.target_hidden = true;
  world.Fence({0.0, 0.0}, 1.0);
  bool wandered = false;
  ASSERT_TRUE(world.RunUntil(
      [&] {
        wandered = wandered || world.Text().find("wandering") != std::string::npos;
        return world.mission().phase() == Phase::kDone;
      },
      200.0))
      << world.Text();
  EXPECT_TRUE(wandered);
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kFailed);
  EXPECT_THAT(world.Text(), HasSubstr("trapped: no way"));
  EXPECT_FALSE(world.Touches());
}

}  // namespace
}  // namespace geon::mission
