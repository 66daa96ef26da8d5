#include "mission/senses.h"

#include <gtest/gtest.h>

#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

class SensesTest : public testing::Test {
 protected:
  Senses senses_{FastOptions(), SmallRig()};
};

TEST_F(SensesTest, StatesGoStale) {
  EXPECT_TRUE(senses_.BaseLost(0.0));
  sensor::BaseState base;
  base.status = sensor::DeviceStatus::kReady;
  senses_.Take(1.0, base);
  EXPECT_FALSE(senses_.BaseLost(1.9));
  EXPECT_TRUE(senses_.BaseLost(2.1));
}

TEST_F(SensesTest, ADeviceThatIsNotReadyIsLostHoweverFresh) {
  sensor::PtuState ptu;
  ptu.status = sensor::DeviceStatus::kStarting;
  senses_.Take(1.0, ptu);
  EXPECT_TRUE(senses_.PtuLost(1.0));
  sensor::LaserState laser;
  laser.status = sensor::DeviceStatus::kFault;
  senses_.Take(1.0, laser);
  EXPECT_TRUE(senses_.StripeCameraLost(1.0));
}

TEST_F(SensesTest, AContactHasTheBearingOfTheBumpersPressed) {
  EXPECT_FALSE(senses_.Contact().has_value());
  sensor::BumperState bumpers;
  bumpers.pressed[2] = bumpers.pressed[3] = true;
  bumpers.bearing_rad[2] = 0.5;
  bumpers.bearing_rad[3] = 0.7;
  senses_.Take(0.0, bumpers);
  EXPECT_NEAR(senses_.Contact().value(), 0.6, 1e-9);
  senses_.Look(0.0);
  EXPECT_EQ(senses_.obstacles_R_m().size(), 2u);
}

TEST_F(SensesTest, EchoesStayWhereTheyWereWhenTheRobotMoves) {
  sensor::BaseState base;
  base.status = sensor::DeviceStatus::kReady;
  senses_.Take(0.0, base);
  sensor::SonarScan sonar;
  sonar.range_m.fill(std::numeric_limits<double>::quiet_NaN());
  sonar.range_m[0] = 1.0;
  senses_.Take(0.0, sonar);
  base.x_m = 0.3;
  base.utime = 1;
  senses_.Take(0.1, base);
  senses_.Look(0.1);
  ASSERT_EQ(senses_.obstacles_R_m().size(), 1u);
  EXPECT_NEAR(senses_.obstacles_R_m()[0].x(), 0.925, 1e-6);
}

TEST_F(SensesTest, AJumpOfOdometryForgetsPlaces) {
  sensor::BaseState base;
  base.status = sensor::DeviceStatus::kReady;
  senses_.Take(0.0, base);
  sensor::SonarScan sonar;
  sonar.range_m.fill(1.0);
  senses_.Take(0.0, sonar);
  base.x_m = 3.0;
  senses_.Take(0.1, base);
  senses_.Look(0.1);
  EXPECT_EQ(senses_.odometry_epoch(), 1);
  EXPECT_TRUE(senses_.obstacles_R_m().empty());
}

TEST_F(SensesTest, TheFloorIsLearnedOnceTheSonarHeardNothingBeforeTheStandingRobot) {
  sensor::BaseState base;
  base.status = sensor::DeviceStatus::kReady;
  sensor::SonarScan sonar;
  sonar.range_m.fill(std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(senses_.FloorPatchIsFree(0.0)) << "nothing was heard yet";
  const auto hear = [&](double now_s, double ahead_m) {
    sonar.range_m[0] = ahead_m;
    senses_.Take(now_s, base);
    senses_.Take(now_s, sonar);
  };
  hear(0.0, 2.0);
  EXPECT_FALSE(senses_.FloorPatchIsFree(1.0)) << "the ring is not round yet";
  hear(1.5, 2.0);
  EXPECT_TRUE(senses_.FloorPatchIsFree(1.5));
  hear(1.6, 0.5);
  EXPECT_FALSE(senses_.FloorPatchIsFree(1.6));
  base.moving = true;
  hear(3.0, 2.0);
  EXPECT_FALSE(senses_.FloorPatchIsFree(3.0));
  base.moving = false;
  hear(4.5, 2.0);
  EXPECT_TRUE(senses_.FloorPatchIsFree(4.5));
}

}  // namespace
}  // namespace geon::mission
