#include "navigation/map_localizer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"
#include "tests/common/navigation/walled_room.h"

namespace geon::navigation {
namespace {

// Robot, its odometry (which says `turn_1` times the turn), the map and the localizer.
class MapLocalizerTest : public ::testing::Test {
 protected:
  void Step(double ahead_m, double turn_rad) {
    truth_rad_ += turn_rad;
    odometry_rad_ += turn_1_ * turn_rad;
    truth_m_ += ahead_m * Eigen::Vector2d(std::cos(truth_rad_), std::sin(truth_rad_));
    odometry_m_ += ahead_m * Eigen::Vector2d(std::cos(odometry_rad_), std::sin(odometry_rad_));
    const auto X_OR = geometry::PlanarPose(odometry_m_.x(), odometry_m_.y(), odometry_rad_);
    const auto X_WR = geometry::PlanarPose(truth_m_.x(), truth_m_.y(), truth_rad_);
    const auto columns = room_.Look(X_WR);
    localizer_.See(X_OR, columns, WalledRoom::kCamera_R_m, map_);
    believed_ = localizer_.X_WO() * X_OR;
    now_s_ += 0.2;
    map_.SeeFloor(now_s_, believed_, columns);
  }
  // Of what is believed, from the truth.
  double HeadingError() const {
    return std::abs(
        WrapAngle(std::atan2(believed_.linear()(1, 0), believed_.linear()(0, 0)) - truth_rad_));
  }
  double PlaceError() const { return (believed_.translation().head<2>() - truth_m_).norm(); }

  WalledRoom room_;
  double turn_1_ = 1.0;
  OccupancyGrid map_{{}};
  MapLocalizer localizer_{{}};
  Eigen::Vector2d truth_m_ = Eigen::Vector2d::Zero(), odometry_m_ = Eigen::Vector2d::Zero();
  double truth_rad_ = 0.0, odometry_rad_ = 0.0, now_s_ = 0.0;
  geometry::RigidTransform believed_ = geometry::RigidTransform::Identity();
};

TEST_F(MapLocalizerTest, TurningOnTheSpotItKeepsTheHeadingThatOdometryLoses) {
  turn_1_ = 1.02;
  for (int i = 0; i < 180; ++i) Step(0.0, 0.14);  // four times round
  EXPECT_GT(std::abs(odometry_rad_ - truth_rad_), 0.45);
  EXPECT_LT(HeadingError(), 0.10);
  EXPECT_LT(PlaceError(), 0.05);
}

TEST_F(MapLocalizerTest, WhatATurnTaughtStillHelpsInTheOpen) {
  turn_1_ = 0.98;
  for (int i = 0; i < 180; ++i) Step(0.0, 0.14);
  EXPECT_NEAR(localizer_.turn_scale_1(), 1.0 / 0.98 - 1.0, 0.012);
  EXPECT_GT(localizer_.turn_scale_1(), 0.008);
  room_.low_m = {-50.0, -50.0};
  room_.high_m = {50.0, 50.0};
  const double before_rad = HeadingError();
  for (int i = 0; i < 45; ++i) Step(0.0, 0.14);
  EXPECT_LT(HeadingError() - before_rad, 0.08) << "odometry alone loses 0.126 rad a turn";
}

TEST_F(MapLocalizerTest, WithoutObstaclesItIsOdometry) {
  room_.low_m = {-50.0, -50.0};
  room_.high_m = {50.0, 50.0};
  for (int i = 0; i < 50; ++i) Step(0.05, 0.1);
  EXPECT_TRUE(localizer_.X_WO().isApprox(geometry::RigidTransform::Identity(), 1e-9));
  EXPECT_EQ(localizer_.turn_scale_1(), 0.0);
}

TEST_F(MapLocalizerTest, GoodOdometryIsNotSpoiled) {
  for (int i = 0; i < 90; ++i) Step(i % 30 < 10 ? 0.05 : 0.0, 0.14);
  EXPECT_LT(HeadingError(), 0.02);
  EXPECT_LT(PlaceError(), 0.03);
}

TEST_F(MapLocalizerTest, ACameraThatLeansToTheSideDoesNotTurnTheMap) {
  for (int i = 0; i < 45; ++i) Step(0.0, 0.14);
  room_.lean_rad = 0.02;  // a wall 1.5 m ahead looks turned by 0.035 rad
  for (int i = 0; i < 6; ++i) Step(0.0, 0.14);
  EXPECT_LT(HeadingError(), 0.02);
}

TEST_F(MapLocalizerTest, AlongASingleWallThePlaceIsAsOdometryHasIt) {
  room_.low_m = {-50.0, -50.0};
  room_.high_m = {50.0, 1.0};  // a wall on the left
  truth_rad_ = odometry_rad_ = 0.6;
  for (int i = 0; i < 6; ++i) Step(0.0, 0.0);
  for (int i = 0; i < 3; ++i) Step(0.0, 0.11);
  truth_m_.y() += 0.06;  // it slipped, toward the wall and along it
  truth_m_.x() += 0.06;
  const double x_m = believed_.translation().x();
  for (int i = 0; i < 8; ++i) Step(0.0, i % 2 == 0 ? 0.11 : -0.11);
  EXPECT_NEAR(believed_.translation().x(), x_m, 0.01);
}

TEST_F(MapLocalizerTest, ResetMakesOdometryTheMapAgain) {
  turn_1_ = 1.02;
  for (int i = 0; i < 60; ++i) Step(0.0, 0.14);
  EXPECT_GT((localizer_.X_WO().matrix() - Eigen::Matrix4d::Identity()).norm(), 0.05);
  localizer_.Reset();
  EXPECT_EQ(localizer_.X_WO().matrix(), Eigen::Matrix4d(Eigen::Matrix4d::Identity()));
  EXPECT_EQ(localizer_.turn_scale_1(), 0.0);
}

TEST(MapLocalizerOptionsTest, WhatMakesNoSenseIsNamed) {
  MapLocalizerOptions options;
  EXPECT_EQ(options.Validate(), std::nullopt);
  options.slip_rad = 0.0;
  EXPECT_NE(options.Validate()->find("odometry"), std::string::npos);
  EXPECT_THROW(MapLocalizer{options}, ContractViolation);
  options = {};
  options.tilt_rad = -1.0;
  EXPECT_NE(options.Validate()->find("pictures"), std::string::npos);
  options = {};
  options.every_m = 0.0;
  EXPECT_NE(options.Validate()->find("every_m"), std::string::npos);
}

}  // namespace
}  // namespace geon::navigation
