// The mission's looking again at a target that the verdict does not decide on (mission.h).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "active_vision/fuse_views.h"
#include "base/angles.h"
#include "mission/mission.h"
#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

using Eigen::Vector2d;
using sensor::MissionOutcome;
using testing::HasSubstr;

// One geon in the middle of a pen, round which there is room; no single look at it decides.
FakeWorld UnsureWorld(double confidence_1, const MissionOptions& options = FastOptions()) {
  FakeWorld world(options);
  world.Fence({0.0, 0.0}, 2.2);
  world.blocks[0].center_W_m = {0.2, 0.1};
  world.pose << -1.5, 0.0, 0.0;
  world.decided = false;
  world.confidence_1 = confidence_1;
  return world;
}

// Bearings of the robot from the target, one per scan.
std::vector<double> Sides(const FakeWorld& world) {
  std::vector<double> sides_rad;
  for (size_t k = 0; k < world.plans.size(); ++k) {
    const Vector2d out_m =
        world.scan_poses[k].head<2>() - world.blocks[world.scanned[k]].center_W_m;
    sides_rad.push_back(std::atan2(out_m.y(), out_m.x()));
  }
  return sides_rad;
}

void ExpectTwentyDegreesApart(const std::vector<double>& sides_rad) {
  for (size_t i = 0; i < sides_rad.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      EXPECT_GE(std::abs(WrapAngle(sides_rad[i] - sides_rad[j])), RadiansFromDegrees(20.0))
          << "scans " << j << " and " << i;
    }
  }
}

TEST(MissionViewsTest, AnUnsureVerdictIsLookedAtFromBesideUntilTheViewsDecide) {
  FakeWorld world = UnsureWorld(0.9);
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed) << world.Text();
  EXPECT_THAT(world.Text(), HasSubstr("the geon is a tapered cuboid"));
  ASSERT_EQ(world.plans.size(), 2U) << "0.9 twice is surer than 0.97";
  ExpectTwentyDegreesApart(Sides(world));
  EXPECT_FALSE(world.Touches());
  EXPECT_FALSE(world.drove_while_scanning);
}

TEST(MissionViewsTest, TheMissionsVerdictIsThatOfAllViewsTogether) {
  FakeWorld world = UnsureWorld(0.7);
  ASSERT_TRUE(world.RunToTheEnd());
  ASSERT_EQ(world.plans.size(), 3U) << world.Text();
  ASSERT_TRUE(world.mission().verdict().has_value());
  const sensor::GeonVerdict& verdict = *world.mission().verdict();
  EXPECT_TRUE(verdict.decided);
  EXPECT_EQ(verdict.label, GeonLabel::kTaperedCuboid);
  // 0.7^3 against the others', 0.18^3 and five times 0.024^3, each to the power of a view's weight.
  const double weight_1 = 3.0 * active_vision::TrainedFusion().weight_1;
  const double right = std::pow(0.7, weight_1);
  EXPECT_NEAR(verdict.confidence,
              right / (right + std::pow(0.18, weight_1) + 5.0 * std::pow(0.024, weight_1)), 1e-9);
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed);
  ExpectTwentyDegreesApart(Sides(world));
}

TEST(MissionViewsTest, NoMoreScansThanPatienceAllows) {
  for (const int views : {1, 2, 3}) {
    SCOPED_TRACE(views);
    MissionOptions options = FastOptions();
    options.patience.views = views;
    FakeWorld world = UnsureWorld(0.4, options);
    ASSERT_TRUE(world.RunToTheEnd());
    EXPECT_EQ(world.plans.size(), static_cast<size_t>(views));
    EXPECT_EQ(world.mission().outcome(), MissionOutcome::kFailed);
    EXPECT_THAT(world.Text(), HasSubstr("does not decide"));
    ASSERT_TRUE(world.mission().verdict().has_value());
    ASSERT_EQ(world.mission().State().findings.size(), 1U);
    EXPECT_EQ(world.mission().State().findings[0].views, views);
    EXPECT_FALSE(world.mission().State().findings[0].decided);
  }
}

TEST(MissionViewsTest, ADecidedVerdictIsNotLookedAtAgain) {
  FakeWorld world = UnsureWorld(0.9);
  world.decided = true;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed);
  EXPECT_EQ(world.plans.size(), 1U);
}

TEST(MissionViewsTest, ByTheThesissRuleOneLookIsAll) {
  MissionOptions options = FastOptions();
  options.driving.planner = PlannerKind::kThesis;
  FakeWorld world = UnsureWorld(0.9, options);
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kFailed);
  EXPECT_EQ(world.plans.size(), 1U);
}

TEST(MissionViewsTest, WhatWasSeenCountsWhereNoOtherSideCanBeReached) {
  // The geon stands in a niche that is the only way out of the robot's half of the pen.
  FakeWorld world = UnsureWorld(0.4);
  world.blocks[0].center_W_m = {1.2, 0.0};
  const cv::Scalar gray(120, 90, 90);
  for (const double side : {-1.0, 1.0}) {
    for (double x_m = -0.4; x_m < 1.5; x_m += 0.3) {
      world.blocks.push_back({{x_m, 0.5 * side}, {0.15, 0.02}, 0.0, 0.3, gray});
    }
  }
  for (double y_m = 0.7; y_m < 2.2; y_m += 0.4) {
    for (const double side : {-1.0, 1.0}) {
      world.blocks.push_back({{-0.55, y_m * side}, {0.02, 0.2}, 0.0, 0.3, gray});
    }
  }
  for (const double y_m : {-0.35, 0.0, 0.35}) {
    world.blocks.push_back({{1.55, y_m}, {0.02, 0.17}, 0.0, 0.3, gray});
  }
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kFailed);
  EXPECT_THAT(world.Text(), HasSubstr("does not decide"));
  ASSERT_EQ(world.mission().State().findings.size(), 1U);
  EXPECT_EQ(world.mission().State().findings[0].views, 1);
  EXPECT_FALSE(world.Touches());
}

}  // namespace
}  // namespace geon::mission
