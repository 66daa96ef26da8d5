#include "mission/approach_phase.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

using testing::HasSubstr;

TEST(ApproachPhaseTest, EndsFacingTheTarget) {
  FakeWorld world(FastOptions());
  world.blocks[0].center_W_m = {1.6, 1.3};
  ASSERT_TRUE(world.RunUntil(Phase::kScan, 90.0)) << world.Text();
  const Eigen::Vector2d away_m = world.blocks[0].center_W_m - world.pose.head<2>();
  EXPECT_NEAR(std::atan2(away_m.y(), away_m.x()), world.pose.z(), 0.3);
}

TEST(ApproachPhaseTest, GoesRoundABoxInTheWay) {
  FakeWorld world(FastOptions());
  world.blocks[0].center_W_m = {2.8, 0.0};
  world.blocks.push_back({{1.4, 0.1}, {0.15, 0.15}, 0.0, 0.3, cv::Scalar(120, 90, 90)});
  ASSERT_TRUE(world.RunUntil(
      [&] {
        EXPECT_FALSE(world.Touches());
        return world.mission().phase() == Phase::kScan || testing::Test::HasFailure();
      },
      150.0))
      << world.Text();
}

// The robot in a closed cell of this size, low enough to look over.
void WallIn(double half_m, double top_m, FakeWorld* world) {
  world->blocks[0].center_W_m = {3.7, 0.0};
  const cv::Scalar gray(120, 90, 90);
  for (const double side : {-1.0, 1.0}) {
    world->blocks.push_back({{0.5, half_m * side}, {half_m, 0.02}, 0.0, top_m, gray});
    world->blocks.push_back({{0.5 + half_m * side, 0.0}, {0.02, half_m}, 0.0, top_m, gray});
  }
  world->pose.x() = 0.5;
}

TEST(ApproachPhaseTest, ByTheThesissRuleItWandersWhenTrappedAndAtLastGivesUpWithTheReason) {
  MissionOptions options = FastOptions();
  options.driving.planner = PlannerKind::kThesis;
  options.patience.traps = 1;
  FakeWorld world(options);
  WallIn(0.65, 0.1, &world);
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kFailed);
  EXPECT_FALSE(world.Touches());
}

TEST(ApproachPhaseTest, ByTheMapATargetWithoutAWayIsUnreachable) {
  FakeWorld world(FastOptions());
  WallIn(1.1, 0.3, &world);
  ASSERT_TRUE(world.RunUntil(
      [&] {
        EXPECT_FALSE(world.Touches());
        return world.mission().phase() == Phase::kDone || testing::Test::HasFailure();
      },
      200.0));
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kUnreachable) << world.Text();
}

TEST(ApproachPhaseTest, ATargetThatIsGoneIsSearchedFor) {
  FakeWorld world(FastOptions());
  world.blocks[0].center_W_m = {3.5, 0.0};
  ASSERT_TRUE(world.RunUntil(Phase::kApproach, 60.0));
  world.target_hidden = true;
  ASSERT_TRUE(world.RunUntil(Phase::kSearch, 30.0)) << world.Text();
  world.target_hidden = false;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
}

}  // namespace
}  // namespace geon::mission
