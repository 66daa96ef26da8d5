#include "mission/back_off_phase.h"

#include <gtest/gtest.h>

#include "base/angles.h"
#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

TEST(BackOffPhaseTest, MovesAwayFromWhatItTouchedAndNotFar) {
  MissionOptions options = FastOptions();
  FakeWorld world(options);
  world.blocks[0].center_W_m = {3.5, 0.0};
  ASSERT_TRUE(world.RunUntil([&] { return world.wishes().velocity.speed_m_s > 0.3; }, 60.0));
  world.bumper_pressed = true;
  ASSERT_TRUE(world.RunUntil(Phase::kBackOff, 0.2));
  world.bumper_pressed = false;
  const Eigen::Vector2d from_m = world.pose.head<2>();
  ASSERT_TRUE(world.RunUntil([&] { return world.mission().phase() != Phase::kBackOff; }, 8.0));
  const Eigen::Vector2d moved_m = world.pose.head<2>() - from_m;
  EXPECT_NEAR(moved_m.norm(), options.driving.back_off_m, 0.05);
  const Eigen::Vector2d ahead(std::cos(world.pose.z()), std::sin(world.pose.z()));
  EXPECT_LT(moved_m.dot(ahead), 0.0);
}

TEST(BackOffPhaseTest, AContactBehindSendsItAhead) {
  FakeWorld world(FastOptions());
  world.target_hidden = true;
  ASSERT_TRUE(world.RunUntil(Phase::kSearch, 5.0));
  world.bumper_pressed = true;
  world.bumper_bearing_rad = 3.0;
  ASSERT_TRUE(world.RunUntil(Phase::kBackOff, 0.2));
  world.Step();
  EXPECT_GT(world.wishes().velocity.speed_m_s, 0.0);
}

// Beside it and ahead: neither way along the heading leads away.
TEST(BackOffPhaseTest, WhoIsBlockedTurnsItsBackToWhatItTouches) {
  FakeWorld world(FastOptions());
  world.target_hidden = true;
  ASSERT_TRUE(world.RunUntil(Phase::kSearch, 5.0));
  world.bumper_pressed = true;
  world.bumper_bearing_rad = 1.4;
  ASSERT_TRUE(world.RunUntil(Phase::kBackOff, 0.2));
  const Eigen::Vector3d touching = world.pose;
  const double away_rad = touching.z() + world.bumper_bearing_rad + kPi;
  const auto turned = [&] { return std::abs(WrapAngle(world.pose.z() - away_rad)) < 0.15; };
  ASSERT_TRUE(world.RunUntil(
      [&] {
        world.pose.head<2>() = touching.head<2>();  // it is held
        world.bumper_bearing_rad = away_rad + kPi - world.pose.z();
        return turned();
      },
      10.0));
  world.bumper_pressed = false;
  ASSERT_TRUE(world.RunUntil([&] { return world.mission().phase() != Phase::kBackOff; }, 8.0));
  const Eigen::Vector2d moved_m = (world.pose - touching).head<2>();
  const Eigen::Vector2d away(std::cos(away_rad), std::sin(away_rad));
  EXPECT_GT(moved_m.dot(away), 0.1);
}

TEST(BackOffPhaseTest, WhoCannotMoveGivesUpMovingButNotTheMission) {
  FakeWorld world(FastOptions());
  world.target_hidden = true;
  ASSERT_TRUE(world.RunUntil(Phase::kSearch, 5.0));
  world.bumper_pressed = true;
  ASSERT_TRUE(world.RunUntil(Phase::kBackOff, 0.2));
  world.bumper_pressed = false;
  const auto pose = world.pose;
  EXPECT_TRUE(world.RunUntil(
      [&] {
        world.pose = pose;  // wheels turn, the robot does not
        return world.mission().phase() == Phase::kSearch;
      },
      20.0));
}

}  // namespace
}  // namespace geon::mission
