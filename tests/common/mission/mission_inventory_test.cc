// The mission that names all geons of a pen (MissionOptions::inventory).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mission/mission.h"
#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

using Eigen::Vector2d;
using sensor::GeonFinding;
using sensor::MissionOutcome;
using testing::HasSubstr;

MissionOptions InventoryOptions() {
  MissionOptions options = FastOptions();
  options.inventory = true;
  return options;
}

// Two geons in opposite corners of a pen.
FakeWorld TwoGeons(const MissionOptions& options = InventoryOptions()) {
  FakeWorld world(options);
  world.Fence({0.0, 0.0}, 2.0);
  world.blocks[0].center_W_m = {0.9, 0.8};
  world.AddGeon({-0.7, -0.9}, GeonLabel::kBentCylinder);
  world.pose << -1.2, 0.8, 0.0;
  return world;
}

// The finding whose place is that of the block, to what its far side hides.
const GeonFinding* FindingOf(const std::vector<GeonFinding>& findings, const Block& block) {
  const auto found = std::find_if(findings.begin(), findings.end(), [&](const GeonFinding& each) {
    return (each.p_W_m - block.center_W_m).norm() < 0.2;
  });
  return found == findings.end() ? nullptr : &*found;
}

TEST(MissionInventoryTest, TwoGeonsAreNamedAtTheirPlacesAndThenThePenIsSurveyed) {
  FakeWorld world = TwoGeons();
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kSurveyed) << world.Text();
  EXPECT_THAT(world.Text(), HasSubstr("2 geons are done with"));
  const auto findings = world.mission().State().findings;
  ASSERT_EQ(findings.size(), 2U);
  for (const Block& block : world.blocks) {
    if (!block.label) continue;
    const GeonFinding* finding = FindingOf(findings, block);
    ASSERT_NE(finding, nullptr) << block.center_W_m.transpose();
    EXPECT_EQ(finding->label, block.label);
    EXPECT_TRUE(finding->decided);
    EXPECT_EQ(finding->confidence, 0.9);
    EXPECT_EQ(finding->views, 1);
    EXPECT_EQ(finding->support_height_m, 0.0);
  }
  EXPECT_FALSE(world.Touches());
}

TEST(MissionInventoryTest, ATargetThatIsDoneWithIsNotScannedAgain) {
  FakeWorld world = TwoGeons();
  ASSERT_TRUE(world.RunToTheEnd());
  ASSERT_EQ(world.scanned.size(), 2U);
  EXPECT_NE(world.scanned[0], world.scanned[1]);
}

TEST(MissionInventoryTest, WithoutItTheFirstGeonIsTheMissionsEnd) {
  FakeWorld world = TwoGeons(FastOptions());
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed) << world.Text();
  EXPECT_EQ(world.mission().State().findings.size(), 1U);
  EXPECT_EQ(world.plans.size(), 1U);
}

TEST(MissionInventoryTest, WithoutAnyGeonNoneIsFound) {
  FakeWorld world(InventoryOptions());
  world.Fence({0.0, 0.0}, 1.5);
  world.target_hidden = true;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNoneFound) << world.Text();
  EXPECT_TRUE(world.mission().State().findings.empty());
}

TEST(MissionInventoryTest, AGeonThatNoWayLeadsToIsAFindingWithoutANameAndTheOtherIsNamed) {
  MissionOptions options = InventoryOptions();
  options.patience.mission_s = 400.0;
  FakeWorld world(options);
  world.Fence({0.0, 0.0}, 2.6);
  world.blocks[0].center_W_m = {1.4, 1.4};
  world.Fence({1.4, 1.4}, 1.08, 0.15);  // low enough to look over
  world.AddGeon({-0.9, -1.2}, GeonLabel::kCylinder);
  world.pose << -1.2, 0.8, 0.0;
  ASSERT_TRUE(world.RunToTheEnd(500.0));
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kSurveyed) << world.Text();
  const auto findings = world.mission().State().findings;
  ASSERT_EQ(findings.size(), 2U);
  const bool first = findings[0].label.has_value();
  const GeonFinding& named = findings[first ? 0 : 1];
  const GeonFinding& closed_in = findings[first ? 1 : 0];
  EXPECT_EQ(named.label, GeonLabel::kCylinder);
  EXPECT_FALSE(closed_in.label.has_value());
  EXPECT_EQ(closed_in.views, 0);
  EXPECT_THAT(closed_in.why, HasSubstr("unreachable"));
  EXPECT_LT((closed_in.p_W_m - world.blocks[0].center_W_m).norm(), 0.35);
}

}  // namespace
}  // namespace geon::mission
