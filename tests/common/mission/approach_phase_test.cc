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

TEST(ApproachPhaseTest, TrappedItWandersAndAtLastGivesUpWithTheReason) {
  MissionOptions options = FastOptions();
  options.patience.traps = 1;
  FakeWorld world(options);
  world.blocks[0].center_W_m = {3.2, 0.0};
  // A cell too narrow to leave, low enough to look over.
  const cv::Scalar gray(120, 90, 90);
  for (const double side : {-1.0, 1.0}) {
    world.blocks.push_back({{0.6, 0.75 * side}, {1.5, 0.02}, 0.0, 0.1, gray});
    world.blocks.push_back({{0.55 + 0.6 * side, 0.0}, {0.02, 0.75}, 0.0, 0.1, gray});
  }
  world.pose.x() = 0.5;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kFailed);
  EXPECT_FALSE(world.Touches());
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
