#include "mission/sweep.h"

#include <gtest/gtest.h>

#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

MissionOptions Sweeping() {
  MissionOptions options = FastOptions();
  options.looking.scan = ScanMode::kSweep;
  return options;
}

TEST(SweepTest, OneTurnOverTheTargetWithEachLaserLaysEveryStripe) {
  FakeWorld world(Sweeping());
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
  EXPECT_EQ(world.sweeps, (std::vector{sensor::Laser::kHorizontal, sensor::Laser::kVertical}));
  EXPECT_TRUE(world.stripe_calls.empty());
  EXPECT_FALSE(world.drove_while_scanning);
}

TEST(SweepTest, IsFasterThanStopping) {
  const auto scan_s = [](const MissionOptions& options) {
    FakeWorld world(options);
    EXPECT_TRUE(world.RunUntil(Phase::kScan, 200.0));
    const double begin_s = world.now_s();
    EXPECT_TRUE(world.RunToTheEnd());
    return world.now_s() - begin_s;
  };
  EXPECT_LT(scan_s(Sweeping()), 0.7 * scan_s(FastOptions()));
}

TEST(SweepTest, WhatTheSweepMissedIsLaidByStopping) {
  FakeWorld world(Sweeping());
  world.never_swept = {1, 5};
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
  ASSERT_EQ(world.stripe_calls.size(), 2U);
  EXPECT_EQ(world.stripe_calls[0].stripe_index + world.stripe_calls[1].stripe_index, 6);
  EXPECT_EQ(world.plans.size(), 1U);
}

TEST(SweepTest, ASweepThatSeesNothingIsNotTheEnd) {
  FakeWorld world(Sweeping());
  world.never_swept = {0, 1, 2, 3, 4, 5};
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), sensor::MissionOutcome::kNamed) << world.Text();
  EXPECT_EQ(world.stripe_calls.size(), 6U);
}

TEST(SweepTest, OfSeveralStripesTheNearestCounts) {
  sensor::ScanPlan plan;
  plan.scan_id = 3;
  for (const double fraction : {0.25, 0.5, 0.75}) {
    plan.stripes.push_back({sensor::Laser::kHorizontal, fraction, 0.0, -0.1 * fraction});
  }
  Sweep sweep(plan, {});
  sensor::RangeProfile profile;
  profile.laser = sensor::Laser::kHorizontal;
  profile.stripe_index = 1;
  profile.on_target = 50;
  for (const double fraction : {0.45, 0.48, 0.53, 0.57}) {
    profile.fraction = fraction;
    sweep.Take(profile);
  }
  EXPECT_EQ(sweep.nearest()[1]->fraction, 0.48);
  profile.stripe_index = 0;
  profile.fraction = 0.33;  // too far beside the first quarter
  sweep.Take(profile);
  profile.fraction = 0.25;
  profile.status = sensor::ProfileStatus::kMissing;
  sweep.Take(profile);
  EXPECT_FALSE(sweep.nearest()[0].has_value());
  EXPECT_FALSE(sweep.done());
}

TEST(SweepTest, ALaserWithOneStripeIsNotSwept) {
  sensor::ScanPlan plan;
  plan.stripes.push_back({sensor::Laser::kVertical, 0.5, 0.0, 0.0});
  EXPECT_TRUE(Sweep(plan, {}).done());
}

}  // namespace
}  // namespace geon::mission
