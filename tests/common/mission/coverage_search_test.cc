#include "mission/coverage_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

using Eigen::Vector2d;
using sensor::MissionOutcome;
using testing::HasSubstr;

constexpr double kPenHalf_m = 1.9;
const cv::Scalar kBoxColor(120, 90, 90);

// A robot in a fenced pen, to search it by the map.
FakeWorld PenWorld(const Vector2d& robot_m = {-1.2, 0.0}, double heading_rad = 0.0) {
  FakeWorld world(FastOptions());
  world.Fence({0.0, 0.0}, kPenHalf_m);
  world.pose << robot_m.x(), robot_m.y(), heading_rad;
  return world;
}

TEST(CoverageSearchTest, AnEmptyPenEndsInTimeWithNoneFound) {
  FakeWorld world = PenWorld();
  world.target_hidden = true;
  const double begin_s = world.now_s();
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNoneFound) << world.Text();
  EXPECT_THAT(world.Text(), HasSubstr("no geon in the reachable pen"));
  EXPECT_LT(world.now_s() - begin_s, 120.0);
  EXPECT_FALSE(world.mission().verdict().has_value());
  EXPECT_TRUE(world.mission().State().findings.empty());
  EXPECT_FALSE(world.Touches());
  EXPECT_EQ(world.wishes().velocity.speed_m_s, 0.0);
}

TEST(CoverageSearchTest, AnEmptyPenWithBoxesIsDrivenRound) {
  FakeWorld world = PenWorld();
  world.target_hidden = true;
  world.blocks.push_back({{0.3, 0.1}, {0.15, 0.5}, 0.0, 1.0, kBoxColor});
  bool went_behind = false;
  ASSERT_TRUE(world.RunUntil(
      [&] {
        EXPECT_FALSE(world.Touches());
        went_behind |= world.pose.x() > 0.5;
        return world.mission().phase() == Phase::kDone || testing::Test::HasFailure();
      },
      240.0))
      << world.Text();
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNoneFound) << world.Text();
  EXPECT_TRUE(went_behind) << "what the box hid was looked at";
}

TEST(CoverageSearchTest, AGeonHiddenBehindABoxIsFound) {
  FakeWorld world = PenWorld();
  world.blocks[0].center_W_m = {0.8, 0.1};
  world.blocks.push_back({{0.3, 0.1}, {0.1, 0.5}, 0.0, 1.0, kBoxColor});
  const Vector2d start_m = world.pose.head<2>();
  ASSERT_TRUE(world.RunUntil(
      [&] {
        return world.mission().phase() == Phase::kCentre ||
               world.mission().phase() == Phase::kApproach;
      },
      150.0))
      << world.Text();
  EXPECT_GT((world.pose.head<2>() - start_m).norm(), 0.5) << "not to be seen from the start";
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed) << world.Text();
  EXPECT_FALSE(world.Touches());
}

TEST(CoverageSearchTest, TheStateShowsThePolygonWhileTheRobotDrives) {
  FakeWorld world = PenWorld();
  world.target_hidden = true;
  world.blocks.push_back({{0.3, 0.1}, {0.15, 0.5}, 0.0, 1.0, kBoxColor});
  int driving = 0, turning = 0;
  world.RunUntil(
      [&] {
        const sensor::PlannerState state = world.mission().State();
        const Vector2d to_waypoint_m = state.p_WWaypoint_m - Vector2d(state.x_m, state.y_m);
        if (world.wishes().velocity.speed_m_s > 0.0) {
          ++driving;
          EXPECT_GE(state.safe_polygon_W_m.size(), 3U) << state.text;
          EXPECT_GT(to_waypoint_m.norm(), 0.0) << state.text;
        } else if (state.text.find("turning round") != std::string::npos) {
          ++turning;
          EXPECT_TRUE(state.safe_polygon_W_m.empty()) << state.text;
          EXPECT_NEAR(to_waypoint_m.norm(), 0.0, 1e-9) << state.text;
        }
        return testing::Test::HasFailure();
      },
      60.0);
  EXPECT_GT(driving, 50);
  EXPECT_GT(turning, 50);
}

TEST(CoverageSearchTest, AGeonBehindTheRobotIsFoundByTurningNotByDriving) {
  FakeWorld world = PenWorld({0.0, 0.0});
  world.blocks[0].center_W_m = {-1.4, -0.2};
  ASSERT_TRUE(world.RunUntil(
      [&] {
        return world.mission().phase() == Phase::kCentre ||
               world.mission().phase() == Phase::kApproach;
      },
      30.0))
      << world.Text();
  EXPECT_LT(world.pose.head<2>().norm(), 0.3);
}

TEST(CoverageSearchTest, AGeonOnADeskIsFound) {
  FakeWorld world = PenWorld();
  world.blocks[0].center_W_m = {1.0, -1.0};
  world.blocks[0].bottom_m = 0.7;
  world.blocks[0].top_m = 0.95;
  world.blocks.push_back({{1.0, -1.0}, {0.25, 0.25}, 0.0, 0.7, kBoxColor});
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed) << world.Text();
  EXPECT_EQ(world.plans.back().support_height_m, 0.7);
}

TEST(CoverageSearchTest, ARoomThatTheRobotCannotEnterIsNotWaitedFor) {
  // Half of the pen lies behind a wall as high as the head.
  FakeWorld world = PenWorld();
  world.target_hidden = true;
  for (double y_m = -1.7; y_m < kPenHalf_m; y_m += 0.4) {
    world.blocks.push_back({{0.3, y_m}, {0.02, 0.2}, 0.0, 1.4, kBoxColor});
  }
  ASSERT_TRUE(world.RunToTheEnd(200.0)) << world.Text();
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNoneFound) << world.Text();
  EXPECT_LT(world.pose.x(), 0.3);
}

TEST(CoverageSearchTest, OdometryThatStartsAnewMakesItLookAgain) {
  FakeWorld world = PenWorld();
  world.target_hidden = true;
  ASSERT_TRUE(world.RunToTheEnd());
  const double empty_s = world.now_s();
  FakeWorld jumped = PenWorld();
  jumped.target_hidden = true;
  const double search_s = empty_s - jumped.now_s();
  jumped.RunUntil([] { return false; }, 0.8 * search_s);
  jumped.pose += Eigen::Vector3d(5.0, 5.0, 0.0);
  for (Block& block : jumped.blocks) block.center_W_m += Vector2d(5.0, 5.0);
  ASSERT_TRUE(jumped.RunToTheEnd());
  EXPECT_EQ(jumped.mission().outcome(), MissionOutcome::kNoneFound) << jumped.Text();
  EXPECT_GT(jumped.now_s(), empty_s + 0.2 * search_s) << "what was seen before counts no more";
}

}  // namespace
}  // namespace geon::mission
