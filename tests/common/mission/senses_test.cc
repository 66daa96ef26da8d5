#include "mission/senses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

#include "base/angles.h"
#include "base/time.h"
#include "tests/common/mission/fake_world.h"
#include "tests/common/navigation/walled_room.h"

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

TEST_F(SensesTest, EchoesAreToldOnceTheRingWasHeardAndWithHowFarTheRobotMovedSince) {
  sensor::BaseState base;
  base.status = sensor::DeviceStatus::kReady;
  sensor::SonarScan sonar;
  sonar.range_m.fill(std::numeric_limits<double>::quiet_NaN());
  sonar.range_m[0] = 0.7;
  EXPECT_FALSE(senses_.Echoes(0.0)) << "nothing was heard yet";
  const auto hear = [&](double now_s) {
    base.utime = MicrosecondsFromSeconds(1.0 + now_s);
    senses_.Take(now_s, base);
    senses_.Take(now_s, sonar);
  };
  for (int i = 0; i <= 15; ++i) hear(0.1 * i);
  EXPECT_FALSE(senses_.Echoes(1.0)) << "the ring is not round yet";
  auto echoes = senses_.Echoes(1.5);
  ASSERT_TRUE(echoes.has_value());
  ASSERT_EQ(echoes->points_R_m.size(), 1U);
  EXPECT_NEAR(echoes->points_R_m[0].x(), 0.925, 1e-6);
  EXPECT_NEAR(echoes->moved_m, 0.0, 1e-9);

  sensor::InfraredScan infrared;
  infrared.level.fill(0);
  infrared.level[0] = 15;
  senses_.Take(1.5, infrared);
  EXPECT_EQ(senses_.Echoes(1.5)->points_R_m.size(), 2U);

  for (int i = 16; i <= 30; ++i) {
    base.x_m += 0.01;
    hear(0.1 * i);
  }
  EXPECT_NEAR(senses_.Echoes(3.0)->moved_m, 0.12, 0.011);
  EXPECT_FALSE(senses_.Echoes(9.0)) << "the base is silent";
}

TEST_F(SensesTest, AContactTakesBackTheSecondLightOfTheFloor) {
  sensor::BaseState base;
  base.status = sensor::DeviceStatus::kReady;
  sensor::SonarScan silence;
  silence.range_m.fill(std::numeric_limits<double>::quiet_NaN());
  double now_s = 0.0;
  const auto shows_obstacles = [&](const cv::Scalar& bgr) {
    const auto& camera = SmallRig().floor_camera;
    sensor::Image image;
    image.width_px = camera.width_px;
    image.height_px = camera.height_px;
    image.row_stride_bytes = 3 * camera.width_px;
    image.format = sensor::PixelFormat::kBgr8;
    const cv::Mat plain(1, image.width_px * image.height_px, CV_8UC3, bgr);
    image.data.assign(plain.datastart, plain.dataend);
    image.utime = base.utime;
    senses_.TakeFloorImage(now_s, image);
    senses_.Look(now_s);
    return senses_.floor()->columns.front().obstacle;
  };
  for (; now_s < 2.0; now_s += 0.1) {
    base.utime = MicrosecondsFromSeconds(1.0 + now_s);
    senses_.Take(now_s, base);
    senses_.Take(now_s, silence);
  }
  const cv::Scalar shade(124, 133, 133), sun(250, 240, 228);
  EXPECT_FALSE(shows_obstacles(shade));
  EXPECT_FALSE(shows_obstacles(sun));
  sensor::BumperState bumpers;
  senses_.Take(now_s, bumpers);
  EXPECT_FALSE(shows_obstacles(sun));
  bumpers.pressed[0] = true;
  senses_.Take(now_s, bumpers);
  EXPECT_TRUE(shows_obstacles(sun));
}

TEST_F(SensesTest, TheMapKeepsTheHeadingThatOdometryLoses) {
  constexpr double kTurn_1 = 1.02, kStep_rad = 0.14;
  navigation::WalledRoom room;
  sensor::BaseState base;
  base.status = sensor::DeviceStatus::kReady;
  double truth_rad = 0.0, odometry_rad = 0.0;
  for (int i = 0; i < 180; ++i) {
    const double now_s = 0.2 * i;
    base.utime = MicrosecondsFromSeconds(1.0 + now_s);
    base.heading_rad = WrapAngle(odometry_rad);
    senses_.Take(now_s, base);
    sensor::Image image;
    image.utime = base.utime;
    FloorSighting seen;
    seen.columns = room.Look(geometry::PlanarPose(0.0, 0.0, truth_rad));
    senses_.TakeFloorImage(now_s, image, seen);
    senses_.Look(now_s);
    truth_rad += kStep_rad;
    odometry_rad += kTurn_1 * kStep_rad;
  }
  truth_rad -= kStep_rad;
  EXPECT_GT(std::abs(WrapAngle(base.heading_rad - truth_rad)), 0.4);
  EXPECT_NEAR(WrapAngle(senses_.base().heading_rad - truth_rad), 0.0, 0.1);
  EXPECT_TRUE(senses_.floor()->X_WR.isApprox(senses_.X_WR(), 1e-9));
}

}  // namespace
}  // namespace geon::mission
