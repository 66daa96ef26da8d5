#include "mission/search_phase.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

// With the planner `map` the search is another: coverage_search_test.
MissionOptions ByTheThesis() {
  MissionOptions options = FastOptions();
  options.driving.planner = PlannerKind::kThesis;
  return options;
}

TEST(SearchPhaseTest, ByTheThesissRuleItSweepsTurnsAndWandersWhenThereIsNothing) {
  FakeWorld world(ByTheThesis());
  world.target_hidden = true;
  bool swept = false;
  bool turned = false;
  bool wandered = false;
  world.RunUntil(
      [&] {
        const auto& velocity = world.wishes().velocity;
        swept = swept || world.Text().find("sweeping") != std::string::npos;
        turned = turned || (velocity.turn_rate_rad_s != 0.0 && velocity.speed_m_s == 0.0);
        wandered = wandered || velocity.speed_m_s > 0.1;
        return swept && turned && wandered;
      },
      120.0);
  EXPECT_TRUE(swept);
  EXPECT_TRUE(turned);
  EXPECT_TRUE(wandered);
  EXPECT_EQ(world.mission().phase(), Phase::kSearch);
}

TEST(SearchPhaseTest, ARowIsSweptWithoutStopping) {
  const MissionOptions options = ByTheThesis();
  FakeWorld world(options);
  world.target_hidden = true;
  ASSERT_TRUE(world.RunUntil(Phase::kSearch, 10.0));
  const double begin_s = world.now_s();
  const double pan_rad = options.looking.sweep.pan_max_rad - options.looking.sweep.pan_min_rad;
  ASSERT_TRUE(world.RunUntil([&] { return world.Text().find("turning") == 0; }, 30.0));
  // Two rows at the head's 1.5 rad/s take 3 s; stopping for a picture at every look took five times
  // that.
  EXPECT_GT(world.now_s() - begin_s, 2.0 * (pan_rad - 0.4) / 1.5);
  EXPECT_LT(world.now_s() - begin_s, 3.0 * 2.0 * pan_rad / 1.5);
}

TEST(SearchPhaseTest, TheHeadCameraFindsWhatStandsHigh) {
  FakeWorld world(FastOptions());
  world.blocks[0].center_W_m = {2.8, 0.9};
  world.blocks[0].bottom_m = 0.7;
  world.blocks[0].top_m = 0.95;
  world.blocks.push_back({{2.8, 0.9}, {0.25, 0.25}, 0.0, 0.7, cv::Scalar(120, 90, 90)});
  ASSERT_TRUE(world.RunUntil(
      [&] {
        return world.mission().phase() != Phase::kWait && world.mission().phase() != Phase::kSearch;
      },
      40.0));
  EXPECT_TRUE(world.mission().phase() == Phase::kCentre ||
              world.mission().phase() == Phase::kApproach);
}

TEST(SearchPhaseTest, TheFloorCameraFindsWhatStandsNear) {
  FakeWorld world(FastOptions());
  world.head_camera_up = true;
  world.blocks[0].center_W_m = {1.4, 0.0};  // below what the head sweeps
  ASSERT_TRUE(world.RunUntil(Phase::kApproach, 5.0)) << world.Text();
}

TEST(SearchPhaseTest, BothPlannersSweepAroundWhereATargetWasLost) {
  for (const PlannerKind planner : {PlannerKind::kThesis, PlannerKind::kMap}) {
    SCOPED_TRACE(ToString(planner));
    MissionOptions options = FastOptions();
    options.driving.planner = planner;
    FakeWorld world(options);
    ASSERT_TRUE(world.RunUntil(Phase::kCentre, 120.0)) << world.Text();
    world.target_hidden = true;
    ASSERT_TRUE(world.RunUntil(Phase::kSearch, 30.0)) << world.Text();
    world.Step();
    EXPECT_EQ(world.Text().find("sweeping"), 0U) << world.Text();
  }
}

}  // namespace
}  // namespace geon::mission
