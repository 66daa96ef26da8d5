#include "mission/scan_phase.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

using testing::HasSubstr;

TEST(ScanPhaseTest, LaysEveryStripeOfThePlanOnceHorizontalOnesFirst) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunToTheEnd());
  ASSERT_EQ(world.stripe_calls.size(), 6u);
  std::set<int> laid;
  for (size_t k = 0; k < 6; ++k) {
    const auto& call = world.stripe_calls[k];
    laid.insert(call.stripe_index);
    EXPECT_EQ(call.laser, k < 3 ? sensor::Laser::kHorizontal : sensor::Laser::kVertical);
    // The head stood where the plan says, or a little beside: by the surface as measured so far.
    const auto& planned = world.plans[0].stripes[static_cast<size_t>(call.stripe_index)];
    EXPECT_EQ(call.laser, planned.laser);
    EXPECT_NEAR(world.stripe_heads[k].pan_rad, planned.pan_rad, 0.02);
    EXPECT_NEAR(world.stripe_heads[k].tilt_rad, planned.tilt_rad, 0.02);
  }
  EXPECT_EQ(laid.size(), 6u);
}

TEST(ScanPhaseTest, ThePlanComesWithTheMaskOfItsTarget) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunToTheEnd());
  ASSERT_EQ(world.masks.size(), world.plans.size());
  const sensor::TargetMask& mask = world.masks[0];
  EXPECT_EQ(mask.scan_id, world.plans[0].scan_id);
  EXPECT_EQ(mask.box, world.plans[0].target_box);
  EXPECT_EQ(mask.pan_rad, world.plans[0].pan_rad);
  EXPECT_EQ(mask.tilt_rad, world.plans[0].tilt_rad);
  int pixels = 0, on_target = 0;
  for (size_t i = 0; i < mask.runs_px.size(); ++i) {
    pixels += mask.runs_px[i];
    if (i % 2 == 1) on_target += mask.runs_px[i];
  }
  EXPECT_EQ(pixels, mask.box.w_px * mask.box.h_px);
  EXPECT_GT(on_target, pixels / 3);
  EXPECT_LT(mask.runs_px.size(), 1000u);  // two bytes each
}

TEST(ScanPhaseTest, AMissingStripeIsAskedForAgainBesideBeforeTheHeadMovesOn) {
  FakeWorld world(FastOptions());
  world.missing_attempts[1] = 1;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
  ASSERT_EQ(world.stripe_calls.size(), 7u);
  size_t first = 0;  // in whatever order they are laid
  while (world.stripe_calls[first].stripe_index != 1) ++first;
  ASSERT_LT(first + 1, world.stripe_calls.size());
  EXPECT_EQ(world.stripe_calls[first + 1].stripe_index, 1);
  EXPECT_EQ(world.stripe_calls[first + 1].attempt, 1);
  EXPECT_NE(world.stripe_heads[first].tilt_rad, world.stripe_heads[first + 1].tilt_rad);
}

TEST(ScanPhaseTest, OneStripeThatNeverComesIsDoneWithout) {
  FakeWorld world(FastOptions());
  world.missing_attempts[3] = 3;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
  EXPECT_EQ(world.plans.size(), 1u);
}

TEST(ScanPhaseTest, TooFewStripesMeanAnotherScanAndAtLastAReason) {
  FakeWorld world(FastOptions());
  for (int k = 0; k < 6; ++k) world.missing_attempts[k] = 1000;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kFailed);
  EXPECT_THAT(world.Text(), HasSubstr("0 stripes were measured"));
  EXPECT_GE(world.plans.size(), 4u);
}

TEST(ScanPhaseTest, TheFirstStripeCorrectsAWrongHeight) {
  MissionOptions options = FastOptions();
  FakeWorld world(options);
  // On a glass table: nothing but the distance tells.
  world.blocks[0].center_W_m = {1.02, 0.0};
  world.blocks[0].bottom_m = 0.7;
  world.blocks[0].top_m = 0.9;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
  ASSERT_FALSE(world.plans.empty());
  EXPECT_EQ(world.plans.back().support_height_m, 0.7);
}

TEST(ScanPhaseTest, NothingAtAllWhereADeskShouldBeMeansAFloorFartherOff) {
  FakeWorld world(FastOptions());
  world.reach_m = 2.0;
  // A box hides the target's foot: it seems to stand on a desk, quite near.
  world.blocks[0].center_W_m = {2.5, 0.0};
  world.blocks[0].top_m = 0.4;
  world.blocks.push_back({{1.15, 0.0}, {0.15, 0.2}, 0.0, 0.6, {120, 120, 120}});
  world.Fence({1.5, 0.0}, 2.5);
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
  ASSERT_GE(world.plans.size(), 2u);
  EXPECT_EQ(world.plans.front().support_height_m, 0.7);
  EXPECT_EQ(world.plans.back().support_height_m, 0.0);
}

TEST(ScanPhaseTest, SilenceOfTheRecognizerSaysNothingOfTheHeight) {
  FakeWorld world(FastOptions());
  world.recognizer_up = false;
  ASSERT_TRUE(world.RunUntil([&] { return world.plans.size() == 2; }, 120.0));
  EXPECT_EQ(world.plans[1].support_height_m, world.plans[0].support_height_m);
  world.recognizer_up = true;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
}

TEST(ScanPhaseTest, ARecognizerThatForgotGetsANewScan) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunUntil([&] { return world.stripe_calls.size() == 4; }, 120.0));
  world.recognizer_seq = 0;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
  ASSERT_EQ(world.plans.size(), 2u);
  EXPECT_NE(world.plans[0].scan_id, world.plans[1].scan_id);
}

TEST(ScanPhaseTest, AStripeCameraThatStaysAwayEndsTheMissionWithAReason) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunUntil(Phase::kScan, 120.0));
  world.stripe_camera_up = false;
  ASSERT_TRUE(world.RunToTheEnd(40.0));
  EXPECT_THAT(world.Text(), HasSubstr("LASER_STATE"));
}

TEST(ScanPhaseTest, ARecognizerThatIsAwayEndsTheMissionWithAReason) {
  FakeWorld world(FastOptions());
  world.recognizer_up = false;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kFailed);
}

}  // namespace
}  // namespace geon::mission
