#include "mission/mission.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "base/contracts.h"
#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

using sensor::MissionOutcome;
using testing::Contains;
using testing::HasSubstr;

Block Desk(const Eigen::Vector2d& center_W_m) {
  return {center_W_m, {0.25, 0.25}, 0.0, 0.7, cv::Scalar(120, 90, 90)};
}

TEST(MissionTest, BeforeItMovesItLearnsTheFloorsColourInTheLightOfTheRoom) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunUntil(Phase::kSearch, 10.0)) << world.Text();
  EXPECT_TRUE(world.mission().senses()->floor_learned());
  EXPECT_EQ(world.pose, Eigen::Vector3d::Zero());
}

TEST(MissionTest, WhereSomethingStandsBeforeItItDoesNotWaitForTheFloor) {
  FakeWorld world(FastOptions());
  world.floor_camera_up = false;
  ASSERT_FALSE(world.RunUntil(Phase::kSearch, 2.0));
  world.floor_camera_up = true;
  world.blocks.push_back({{0.6, 0.0}, {0.1, 0.5}, 0.0, 1.0, cv::Scalar(120, 90, 90)});
  const double since_s = world.now_s();
  ASSERT_TRUE(world.RunUntil(Phase::kSearch, 10.0)) << world.Text();
  EXPECT_FALSE(world.mission().senses()->floor_learned());
  EXPECT_LT(world.now_s() - since_s, 2.5);
}

TEST(MissionTest, FindsApproachesScansAndNamesAGeonOnTheFloor) {
  FakeWorld world(FastOptions());
  world.pose.z() = 2.5;  // looks away from it
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed) << world.Text();
  EXPECT_EQ(world.mission().verdict()->label, GeonLabel::kTaperedCuboid);
  EXPECT_THAT(world.Text(), HasSubstr("tapered cuboid"));
  ASSERT_EQ(world.plans.size(), 1u);
  EXPECT_EQ(world.plans[0].support_height_m, 0.0);
  EXPECT_EQ(world.plans[0].stripes.size(), 6u);
  EXPECT_EQ(world.stripe_calls.size(), 6u);
  EXPECT_FALSE(world.Touches());
  EXPECT_FALSE(world.drove_while_scanning);
  EXPECT_LT(world.now_s(), 200.0);
}

TEST(MissionTest, StopsAboutNinetyCentimetresBeforeTheGeon) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunUntil(Phase::kScan, 120.0)) << world.Text();
  const double distance_m = (world.pose.head<2>() - world.blocks[0].center_W_m).norm();
  EXPECT_GT(distance_m, 0.85);
  EXPECT_LT(distance_m, 1.15);  // to the middle; the foot is 0.1 m nearer
}

TEST(MissionTest, KnowsByItselfThatAGeonStandsOnTheDesk) {
  FakeWorld world(FastOptions());
  world.blocks[0].bottom_m = 0.7;
  world.blocks[0].top_m = 0.95;
  world.blocks.push_back(Desk(world.blocks[0].center_W_m));
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed) << world.Text();
  ASSERT_FALSE(world.plans.empty());
  EXPECT_EQ(world.plans.back().support_height_m, 0.7);
  EXPECT_FALSE(world.Touches());
}

TEST(MissionTest, WithoutAGeonItEndsWhenItsTimeIsOver) {
  MissionOptions options = FastOptions();
  options.patience.mission_s = 60.0;
  FakeWorld world(options);
  world.target_hidden = true;
  ASSERT_TRUE(world.RunToTheEnd(61.0));
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kFailed);
  EXPECT_THAT(world.Text(), HasSubstr("time is over"));
  EXPECT_THAT(world.Text(), HasSubstr("search"));
}

TEST(MissionTest, AnUndecidedVerdictIsNoName) {
  FakeWorld world(FastOptions());
  world.decided = false;
  world.confidence_1 = 0.4;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kFailed);
  EXPECT_THAT(world.Text(), HasSubstr("does not decide"));
}

TEST(MissionTest, GoesOnWhenThePtuComesBackInMidScan) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunUntil([&] { return world.stripe_calls.size() == 3; }, 120.0));
  world.ptu_up = false;
  world.RunUntil([] { return false; }, 6.0);
  EXPECT_EQ(world.mission().phase(), Phase::kScan);
  EXPECT_THAT(world.Text(), HasSubstr("PTU_STATE"));
  world.ptu_up = true;
  world.head = {};  // it has homed meanwhile
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed) << world.Text();
  EXPECT_EQ(world.plans.size(), 1u);
}

TEST(MissionTest, EveryDeviceThatStaysAwayEndsItWithAReason) {
  const std::vector<std::pair<bool FakeWorld::*, std::string>> devices = {
      {&FakeWorld::ptu_up, "PTU_STATE"},
      {&FakeWorld::base_up, "BASE_STATE"},
      {&FakeWorld::head_camera_up, "COLOR_IMAGE"},
      {&FakeWorld::floor_camera_up, "FLOOR_IMAGE"}};
  for (const auto& [device, name] : devices) {
    FakeWorld world(FastOptions());
    world.*device = false;
    ASSERT_TRUE(world.RunToTheEnd(30.0)) << name;
    EXPECT_EQ(world.mission().outcome(), MissionOutcome::kFailed);
    EXPECT_THAT(world.Text(), HasSubstr(name));
  }
}

TEST(MissionTest, StandsWhileTheBaseIsAwayAndGoesOnAfterwards) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunUntil(Phase::kApproach, 60.0));
  world.base_up = false;
  world.RunUntil([] { return false; }, 2.0);
  EXPECT_EQ(world.wishes().velocity.speed_m_s, 0.0);
  EXPECT_THAT(world.Text(), HasSubstr("BASE_STATE"));
  world.base_up = true;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed) << world.Text();
}

TEST(MissionTest, DoesNotDriveAheadOnOldPicturesOfTheFloor) {
  FakeWorld world(FastOptions());
  world.blocks[0].center_W_m = {4.0, 0.0};
  ASSERT_TRUE(world.RunUntil([&] { return world.wishes().velocity.speed_m_s > 0.3; }, 60.0));
  world.floor_camera_up = false;
  world.RunUntil([] { return false; }, 1.5);
  EXPECT_EQ(world.wishes().velocity.speed_m_s, 0.0);
}

TEST(MissionTest, AContactIsBackedOffFromAndTheMissionGoesOn) {
  FakeWorld world(FastOptions());
  world.blocks[0].center_W_m = {3.5, 0.0};
  ASSERT_TRUE(world.RunUntil([&] { return world.wishes().velocity.speed_m_s > 0.3; }, 60.0));
  world.bumper_pressed = true;
  ASSERT_TRUE(world.RunUntil(Phase::kBackOff, 0.2));
  const Eigen::Vector2d before_m = world.pose.head<2>();
  world.Step();
  EXPECT_LT(world.wishes().velocity.speed_m_s, 0.0);
  world.bumper_pressed = false;
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed) << world.Text();
  EXPECT_GT((world.pose.head<2>() - before_m).norm(), 0.0);
}

TEST(MissionTest, TooManyContactsEndIt) {
  MissionOptions options = FastOptions();
  options.patience.bumps = 1;
  FakeWorld world(options);
  world.bumper_pressed = true;
  world.bumper_bearing_rad = 3.0;
  ASSERT_TRUE(world.RunToTheEnd(120.0));
  EXPECT_THAT(world.Text(), HasSubstr("bumped"));
}

TEST(MissionTest, OdometryThatStartsAnewMakesItSearchAgain) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunUntil(Phase::kApproach, 60.0));
  world.pose += Eigen::Vector3d(5.0, 5.0, 0.0);
  world.blocks[0].center_W_m += Eigen::Vector2d(5.0, 5.0);
  ASSERT_TRUE(world.RunUntil(Phase::kSearch, 1.0));
  ASSERT_TRUE(world.RunToTheEnd());
  EXPECT_EQ(world.mission().outcome(), MissionOutcome::kNamed) << world.Text();
}

TEST(MissionTest, TheEndIsKept) {
  FakeWorld world(FastOptions());
  ASSERT_TRUE(world.RunToTheEnd());
  const std::string text = world.Text();
  world.RunUntil([] { return false; }, 5.0);
  EXPECT_EQ(world.mission().phase(), Phase::kDone);
  EXPECT_EQ(world.Text(), text);
  EXPECT_EQ(world.wishes().velocity.speed_m_s, 0.0);
}

// Whatever happens around it: wishes stay finite and bounded, nothing drives during a scan, and the
// mission ends in time.
TEST(MissionTest, RandomTroubleNeverMakesItUnsafeOrEndless) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 random(seed);
    const auto one_in = [&](unsigned n) { return random() % n == 0; };
    MissionOptions options = FastOptions();
    options.patience.mission_s = 90.0;
    FakeWorld world(options);
    world.blocks.push_back(Desk({1.0, -1.2}));
    const double start_s = world.now_s();
    while (world.mission().phase() != Phase::kDone) {
      if (one_in(80)) world.ptu_up = !world.ptu_up || one_in(2);
      if (one_in(80)) world.base_up = !world.base_up || one_in(2);
      if (one_in(80)) world.stripe_camera_up = !world.stripe_camera_up;
      if (one_in(80)) world.recognizer_up = !world.recognizer_up;
      if (one_in(80)) world.head_camera_up = !world.head_camera_up;
      if (one_in(80)) world.target_hidden = !world.target_hidden;
      if (one_in(100)) world.recognizer_seq = 0;
      if (one_in(100)) world.pose.x() += 0.02;
      if (one_in(60)) world.missing_attempts[static_cast<int>(random() % 6)] = 3;
      world.bumper_pressed = one_in(200);
      world.bumper_bearing_rad = static_cast<double>(random() % 628) / 100.0;
      world.Step();
      const auto& velocity = world.wishes().velocity;
      ASSERT_LE(std::abs(velocity.speed_m_s), options.driving.velocity.max_speed_m_s);
      ASSERT_LE(std::abs(velocity.turn_rate_rad_s), options.driving.velocity.max_turn_rate_rad_s);
      ASSERT_TRUE(std::isfinite(velocity.speed_m_s) && std::isfinite(velocity.turn_rate_rad_s));
      if (world.wishes().head) {
        ASSERT_TRUE(std::isfinite(world.wishes().head->pan_rad));
        ASSERT_TRUE(std::isfinite(world.wishes().head->tilt_rad));
      }
      ASSERT_LE(world.now_s() - start_s, options.patience.mission_s + 0.2) << "seed " << seed;
    }
    EXPECT_FALSE(world.drove_while_scanning) << "seed " << seed;
    EXPECT_FALSE(world.Text().empty());
  }
}

TEST(MissionTest, RefusesBadOptionsAndTimeRunningBackwards) {
  MissionOptions options = FastOptions();
  options.looking.support_heights_m.clear();
  EXPECT_THROW(Mission(options, SmallRig(), 1, 0.0), ContractViolation);
  Mission mission(FastOptions(), SmallRig(), 1, 10.0);
  EXPECT_THROW(mission.Step(9.0), ContractViolation);
}

}  // namespace
}  // namespace geon::mission
