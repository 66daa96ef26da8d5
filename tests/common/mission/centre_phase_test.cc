#include "mission/centre_phase.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

using testing::Contains;
using testing::HasSubstr;

TEST(CentrePhaseTest, TheScanStartsWithTheWholeTargetInView) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunUntil([&] { return !world.plans.empty(); }, 90.0)) << world.Text();
  const auto& box = world.plans[0].target_box;
  EXPECT_GT(box.u_px, 0);
  EXPECT_GT(box.v_px, 0);
  EXPECT_LT(box.u_px + box.w_px, 160);
  EXPECT_LT(box.v_px + box.h_px, 120);
}

TEST(CentrePhaseTest, ATargetTooLargeForThePictureIsSteppedBackFrom) {
  FakeWorld world(FastOptions());
  world.blocks[0].half_m = {0.1, 0.34};  // wider than the view at 90 cm
  world.blocks[0].bottom_m = 0.7;
  world.blocks[0].top_m = 0.8;
  world.blocks.push_back(
      {world.blocks[0].center_W_m, {0.2, 0.4}, 0.0, 0.7, cv::Scalar(120, 90, 90)});
  world.RunToTheEnd();
  EXPECT_THAT(world.phases, Contains(Phase::kBackOff));
  EXPECT_FALSE(world.Touches());
}

TEST(CentrePhaseTest, ATargetThatVanishesIsSearchedForAround) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunUntil(Phase::kCentre, 60.0));
  world.target_hidden = true;
  ASSERT_TRUE(world.RunUntil(Phase::kSearch, 30.0)) << world.Text();
}

TEST(CentrePhaseTest, ARobotThatTurnsOnKeepsItsGazeOnWhatItSaw) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunUntil(Phase::kCentre, 60.0));
  const double before_s = world.now_s();
  world.target_hidden = true;  // no picture of it corrects the gaze meanwhile
  world.coast_rad_s = 0.8;
  while (world.now_s() < before_s + 0.6) world.Step();
  world.coast_rad_s = 0.0;
  world.target_hidden = false;
  ASSERT_TRUE(world.RunUntil([&] { return world.mission().phase() != Phase::kCentre; }, 30.0));
  EXPECT_EQ(world.phases.back(), Phase::kApproach) << world.Text();
}

TEST(CentrePhaseTest, ATargetThatLeavesThePictureIsFollowed) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunUntil(Phase::kScan, 90.0));
  world.recognizer_up = false;  // the scan fails, the target moves meanwhile
  world.blocks[0].center_W_m += Eigen::Vector2d(0.05, 0.15);
  ASSERT_TRUE(world.RunUntil(Phase::kCentre, 150.0)) << world.Text();
  world.recognizer_up = true;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
}

}  // namespace
}  // namespace geon::mission
