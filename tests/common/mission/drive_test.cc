#include "mission/drive.h"

#include <gtest/gtest.h>

#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

class DriveTest : public testing::Test {
 protected:
  DriveTest() {
    sensor::BaseState base;
    base.status = sensor::DeviceStatus::kReady;
    senses_.Take(0.0, base);
  }
  void Echo(int sensor, double range_m) {
    sensor::SonarScan sonar;
    sonar.range_m.fill(std::numeric_limits<double>::quiet_NaN());
    sonar.range_m[static_cast<size_t>(sensor)] = range_m;
    senses_.Take(0.0, sonar);
    senses_.Look(0.0);
  }
  MissionOptions options_ = FastOptions();
  Senses senses_{options_, SmallRig()};
  Drive drive_{options_, 1};
};

TEST_F(DriveTest, TheTargetItselfDoesNotBendTheWay) {
  Echo(0, 1.2);  // the target, 1.425 m ahead
  drive_.Toward(0.0, senses_, {1.5, 0.0}, 0.93);
  EXPECT_NEAR(drive_.waypoint_R_m().x(), 0.57, 1e-9);
  EXPECT_NEAR(drive_.waypoint_R_m().y(), 0.0, 1e-9);
}

TEST_F(DriveTest, SomethingElseAheadDoes) {
  Echo(0, 1.2);
  drive_.Toward(0.0, senses_, {3.0, 0.5}, 0.93);
  EXPECT_NEAR(drive_.waypoint_R_m().x(), 1.425 - options_.driving.safe_polygon.clearance_m, 1e-6);
  EXPECT_GT(drive_.waypoint_R_m().y(), 1.0);
}

TEST_F(DriveTest, SpeedGrowsGentlyFromRest) {
  drive_.Toward(0.0, senses_, {3.0, 0.0}, 0.93);
  const double first_m_s = drive_.Toward(0.05, senses_, {3.0, 0.0}, 0.93).speed_m_s;
  EXPECT_LE(first_m_s, 0.05 * options_.driving.velocity.acceleration_m_s2);
  EXPECT_GT(drive_.Toward(0.10, senses_, {3.0, 0.0}, 0.93).speed_m_s, first_m_s);
}

TEST_F(DriveTest, WanderingKeepsItsWaypointUntilItIsOld) {
  drive_.Wander(0.0, senses_);
  const Eigen::Vector2d waypoint_m = drive_.waypoint_R_m();
  drive_.Wander(1.0, senses_);
  EXPECT_EQ(drive_.waypoint_R_m(), waypoint_m);
  bool changed = false;
  for (int i = 1; i < 10; ++i) {
    drive_.Wander(10.0 * i, senses_);
    changed = changed || drive_.waypoint_R_m() != waypoint_m;
  }
  EXPECT_TRUE(changed);
}

TEST_F(DriveTest, AtTheStoppingPlaceItRests) {
  const auto velocity = drive_.Toward(0.0, senses_, {0.9, 0.0}, 0.93);
  EXPECT_EQ(velocity.speed_m_s, 0.0);
  EXPECT_EQ(velocity.turn_rate_rad_s, 0.0);
}

}  // namespace
}  // namespace geon::mission
