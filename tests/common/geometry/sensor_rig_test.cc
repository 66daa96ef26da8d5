#include "geometry/sensor_rig.h"

#include <gtest/gtest.h>

#include "base/angles.h"

namespace geon::geometry {
namespace {

SensorRig PitchedRig() {
  SensorRig rig;
  rig.X_RP = MakeTransform(RotationAboutY(RadiansFromDegrees(15)), Eigen::Vector3d(0, 0, 1.2));
  rig.X_TB = MakeTransform(CameraAxesInBody(), Eigen::Vector3d(0.05, 0, 0));
  return rig;
}

TEST(SensorRigTest, MountPitchedDownLooksDown) {
  const RigidTransform X_RB = PitchedRig().StripeCameraPose(0.0, 0.0);
  const Eigen::Vector3d axis_R = X_RB.linear().col(2);
  EXPECT_NEAR(axis_R.z(), -std::sin(RadiansFromDegrees(15)), 1e-12);
  EXPECT_NEAR(axis_R.y(), 0.0, 1e-12);
}

TEST(SensorRigTest, LowestTiltReachesTheFloorAtSeventyCentimetres) {
  // tilt limit -46.65 degrees and pitch 15 degrees: the axis meets the floor 0.65 m ahead.
  const RigidTransform X_RT = PitchedRig().HeadPose(0.0, RadiansFromDegrees(-46.65));
  const Eigen::Vector3d axis_R = X_RT.linear().col(0);
  EXPECT_NEAR(1.2 * axis_R.x() / -axis_R.z(), 0.65, 0.01);
}

TEST(SensorRigTest, PositivePanLooksLeftAndPositiveTiltUp) {
  SensorRig rig;
  rig.X_TB = MakeTransform(CameraAxesInBody(), Eigen::Vector3d::Zero());
  EXPECT_GT(rig.StripeCameraPose(0.2, 0.0).linear().col(2).y(), 0.0);
  EXPECT_GT(rig.StripeCameraPose(0.0, 0.2).linear().col(2).z(), 0.0);
}

TEST(SensorRigTest, LevelFrameStandsBelowTheCameraAndIsLevel) {
  const RigidTransform X_RB = PitchedRig().StripeCameraPose(0.3, -0.4);
  const RigidTransform X_RL = LevelFrame(X_RB, 0.7);
  EXPECT_NEAR(X_RL.linear()(2, 2), 1.0, 1e-12);
  const Eigen::Vector3d p_LB = X_RL.inverse() * X_RB.translation();
  EXPECT_NEAR(p_LB.head<2>().norm(), 0.0, 1e-12);
  EXPECT_NEAR(p_LB.z(), X_RB.translation().z() - 0.7, 1e-12);
  const Eigen::Vector3d axis_L = X_RL.linear().transpose() * X_RB.linear().col(2);
  EXPECT_NEAR(axis_L.y(), 0.0, 1e-12);
  EXPECT_GT(axis_L.x(), 0.0);
}

TEST(PinholeCameraTest, RayAndProjectionAreInverse) {
  const PinholeCamera camera;
  const Eigen::Vector2d pixel_px = camera.Project(camera.Ray(12.25, 401.5) * 1.7);
  EXPECT_NEAR(pixel_px.x(), 12.25, 1e-9);
  EXPECT_NEAR(pixel_px.y(), 401.5, 1e-9);
  EXPECT_TRUE(camera.Contains(pixel_px));
  EXPECT_FALSE(camera.Contains({640.0, 0.0}));
}

TEST(PinholeCameraTest, LensDistortionMovesTheCornersAndIsUndone) {
  PinholeCamera camera;
  camera.k1_1 = -0.12;
  camera.k2_1 = 0.3;
  // The corner's r is 0.2497: 1 - 0.12 r^2 + 0.3 r^4 = 0.99369.
  const Eigen::Vector3d corner(320.0 / 1600.0, 239.5 / 1600.0, 1.0);
  const double r2 = corner.head<2>().squaredNorm();
  const Eigen::Vector2d seen_px = camera.Project(corner);
  EXPECT_NEAR((seen_px.x() - 319.5) / 320.0, 1.0 - 0.12 * r2 + 0.3 * r2 * r2, 1e-12);
  EXPECT_LT(seen_px.x(), PinholeCamera{}.Project(corner).x() - 1.0);
  EXPECT_LT((camera.Ray(seen_px.x(), seen_px.y()) - corner).norm(), 1e-12);
}

TEST(SensorRigTest, ARayMeetsTheFanWhereThePlaneIs) {
  SensorRig rig = PitchedRig();
  LaserMount fan;  // 10 cm to the left, looking inwards: meets the axis 1 m ahead
  fan.p_TLaser_m = {0.05, 0.1, 0.0};
  fan.normal_T = Eigen::Vector3d(0.1, 1.0, 0.0).normalized();
  EXPECT_NEAR(rig.DistanceToFan(fan, {0.0, 0.0, 1.0}), 1.0, 1e-12);
  // A ray 0.1 to the left of it: 0.1 z = 0.1 - 0.1 z.
  const double left_m = rig.DistanceToFan(fan, {-0.1, 0.3, 1.0});
  EXPECT_NEAR(left_m, 0.5, 1e-12);
  const Eigen::Vector3d p_T_m = rig.X_TB * (left_m * Eigen::Vector3d(-0.1, 0.3, 1.0));
  EXPECT_NEAR(fan.normal_T.dot(p_T_m - fan.p_TLaser_m), 0.0, 1e-12);
  EXPECT_LT(rig.DistanceToFan(fan, {0.3, 0.0, 1.0}), 0.0);
}

TEST(SensorRigTest, TheHeadTurnsAboutTheTiltAxisThatTheUnitHas) {
  SensorRig rig;
  rig.ptu_axes = {0.01, -0.02, Eigen::Vector3d(0.003, 0.0, 0.002)};
  // A point of the tilt axis stays where it is, whatever the tilt, and turns with pan.
  const Eigen::Vector3d axis(std::sin(0.02) * std::cos(0.01), std::cos(0.02) * std::cos(0.01),
                             std::sin(0.01));
  const Eigen::Vector3d p_T_m = rig.ptu_axes.p_PTilt_m + 0.3 * axis;
  EXPECT_LT((rig.HeadPose(0.0, 0.7) * p_T_m - p_T_m).norm(), 1e-12);
  EXPECT_LT((rig.HeadPose(0.5, 0.7) * p_T_m - RotationAboutZ(0.5) * p_T_m).norm(), 1e-12);
  // At 0, 0 the head is where the drawing has it.
  EXPECT_TRUE(rig.HeadPose(0.0, 0.0).isApprox(RigidTransform::Identity(), 1e-12));
}

}  // namespace
}  // namespace geon::geometry
