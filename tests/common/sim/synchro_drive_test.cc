#include "sim/synchro_drive.h"

#include <gtest/gtest.h>

#include "base/contracts.h"
#include "tests/common/sim/device_testing.h"

namespace geon::sim {
namespace {

constexpr double kStep_s = 0.004;

void Pass(SynchroDrive* drive, double duration_s) {
  for (double t_s = 0.0; t_s < duration_s; t_s += kStep_s) drive->Step(kStep_s);
}

TEST(SynchroDrive, DrivesWhereItsWheelsPoint) {
  const FreeSpace world;
  SynchroDriveOptions options;
  options.x_m = 1.0;
  options.y_m = 2.0;
  options.heading_rad = kPi / 2;
  SynchroDrive drive(options, &world);
  drive.MoveBy(Servo::kTranslation, 0.5);
  Pass(&drive, 4.0);
  EXPECT_NEAR(drive.center_W_m().x(), 1.0, 1e-6);
  EXPECT_NEAR(drive.center_W_m().y(), 2.5, 1e-6);
  // Odometry starts at its own zero, looking along its own x axis.
  EXPECT_NEAR(drive.odometry_m().x(), 0.5, 1e-6);
  EXPECT_NEAR(drive.odometry_m().y(), 0.0, 1e-6);
  EXPECT_FALSE(drive.moving(Servo::kTranslation));
}

TEST(SynchroDrive, TurnsOnTheSpotWhileTheBaseKeepsItsOrientation) {
  const FreeSpace world;
  SynchroDrive drive({}, &world);
  drive.MoveBy(Servo::kSteering, kPi / 2);
  Pass(&drive, 5.0);
  EXPECT_NEAR(drive.heading_W_rad(), kPi / 2, 1e-6);
  EXPECT_NEAR(drive.turret_W_rad(), 0.0, 1e-9);
  EXPECT_EQ(drive.base_W_rad(), 0.0);
}

TEST(SynchroDrive, ATiedTurretTurnsWithTheWheelsToTheSameAngle) {
  const FreeSpace world;
  SynchroDrive drive({}, &world);
  drive.TieTurret(true);
  drive.RunAt(Servo::kSteering, 0.4);
  Pass(&drive, 2.0);
  EXPECT_TRUE(drive.moving(Servo::kTurret));
  drive.Hold(Servo::kSteering);
  Pass(&drive, 2.0);
  EXPECT_GT(drive.heading_W_rad(), 0.5);
  EXPECT_DOUBLE_EQ(drive.turret_W_rad(), drive.heading_W_rad());
  EXPECT_DOUBLE_EQ(drive.position(Servo::kTurret), drive.position(Servo::kSteering));
  EXPECT_FALSE(drive.moving(Servo::kTurret));
}

TEST(SynchroDrive, ObeysItsOwnLimitsWhateverIsAsked) {
  const FreeSpace world;
  const SynchroDriveOptions options;
  SynchroDrive drive(options, &world);
  drive.SetAcceleration(Servo::kTranslation, 100.0);
  drive.RunAt(Servo::kTranslation, 9.0);
  drive.RunAt(Servo::kSteering, -9.0);
  drive.Step(kStep_s);
  EXPECT_LE(drive.velocity(Servo::kTranslation), options.max_acceleration_m_s2 * kStep_s + 1e-12);
  Pass(&drive, 3.0);
  EXPECT_NEAR(drive.velocity(Servo::kTranslation), 0.508, 1e-9);
  EXPECT_NEAR(drive.velocity(Servo::kSteering), -RadiansFromDegrees(60.0), 1e-9);
}

TEST(SynchroDrive, HoldsWithinTheSafetyDistance) {
  const FreeSpace world;
  SynchroDrive drive({}, &world);
  drive.RunAt(Servo::kTranslation, 0.508);
  Pass(&drive, 3.0);
  const double before_m = drive.odometry_m().x();
  drive.Hold(Servo::kTranslation);
  Pass(&drive, 0.36);
  EXPECT_EQ(drive.true_speed_m_s(), 0.0);
  EXPECT_LT(drive.odometry_m().x() - before_m, 0.10);
}

TEST(SynchroDrive, AWallStopsItHeadOnAndTheWheelsStall) {
  const Walls world({{{-1.0, 0.0}, -1.0}});  // wall at x = 1
  SynchroDrive drive({}, &world);
  drive.RunAt(Servo::kTranslation, 0.5);
  Pass(&drive, 5.0);
  EXPECT_NEAR(drive.center_W_m().x(), 1.0 - 0.267, 0.003);
  EXPECT_NEAR(drive.odometry_m().x(), drive.center_W_m().x(), 1e-9);
  EXPECT_EQ(drive.true_speed_m_s(), 0.0);
  ASSERT_EQ(drive.contacts().size(), 1u);
  EXPECT_LE(drive.contacts()[0].clearance_m, 0.0);
  // It can leave the wall again.
  drive.RunAt(Servo::kTranslation, -0.5);
  Pass(&drive, 1.0);
  EXPECT_LT(drive.center_W_m().x(), 0.6);
}

TEST(SynchroDrive, SlidesAlongAWallAndItsOdometryDoesNotKnow) {
  const Walls world({{{-1.0, 0.0}, -0.4}});  // wall at x = 0.4
  SynchroDrive drive({}, &world);
  drive.MoveBy(Servo::kSteering, RadiansFromDegrees(60.0));
  Pass(&drive, 3.0);
  drive.RunAt(Servo::kTranslation, 0.3);
  Pass(&drive, 4.0);
  EXPECT_NEAR(drive.center_W_m().x(), 0.4 - 0.267, 0.003);
  EXPECT_GT(drive.center_W_m().y(), 0.5);
  EXPECT_GT(drive.odometry_m().x() - drive.center_W_m().x(), 0.2);
}

TEST(SynchroDrive, StopsInACorner) {
  const Walls world({{{-1.0, 0.0}, -0.5}, {{0.0, -1.0}, -0.5}});
  SynchroDrive drive({}, &world);
  drive.MoveBy(Servo::kSteering, RadiansFromDegrees(50.0));
  Pass(&drive, 3.0);
  drive.RunAt(Servo::kTranslation, 0.3);
  Pass(&drive, 6.0);
  EXPECT_NEAR(drive.center_W_m().x(), 0.233, 0.004);
  EXPECT_NEAR(drive.center_W_m().y(), 0.233, 0.004);
}

TEST(SynchroDrive, OdometryScalesPartItFromTheTruth) {
  const FreeSpace world;
  SynchroDriveOptions options;
  options.odometry_distance_scale_1 = 1.02;
  options.odometry_turn_scale_1 = 0.98;
  SynchroDrive drive(options, &world);
  drive.MoveBy(Servo::kTranslation, 1.02);
  drive.MoveBy(Servo::kSteering, 0.98);
  Pass(&drive, 10.0);
  EXPECT_NEAR(drive.heading_W_rad(), 1.0, 1e-6);
  EXPECT_NEAR(drive.odometry_m().norm() / drive.center_W_m().norm(), 1.02, 0.01);
}

TEST(SynchroDrive, PowerCyclingForgetsEverythingButThePlace) {
  const FreeSpace world;
  SynchroDrive drive({}, &world);
  drive.RunAt(Servo::kTranslation, 0.3);
  Pass(&drive, 2.0);
  const Eigen::Vector2d place_W_m = drive.center_W_m();
  drive.PowerCycle();
  Pass(&drive, 1.0);
  EXPECT_EQ(drive.center_W_m(), place_W_m);
  EXPECT_EQ(drive.odometry_m(), Eigen::Vector2d::Zero().eval());
  EXPECT_EQ(drive.position(Servo::kTranslation), 0.0);
}

TEST(SynchroDrive, RefusesToStandNowhere) {
  EXPECT_THROW(SynchroDrive({}, nullptr), ContractViolation);
}

}  // namespace
}  // namespace geon::sim
