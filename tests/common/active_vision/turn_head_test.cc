#include "active_vision/turn_head.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/common/active_vision/test_rig.h"

namespace geon::active_vision {
namespace {

// The point seen from the turned head.
Eigen::Vector3d InHead(const Eigen::Vector3d& p_P_m, const HeadAngles& head) {
  return (geometry::RotationAboutZ(head.pan_rad) * geometry::RotationAboutY(-head.tilt_rad))
             .transpose() *
         p_P_m;
}

TEST(TurnHeadTest, PlaneHoldsThePointAfterTheTurn) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> side(-0.5, 0.5);
  const geometry::SensorRig rig = TestRig();
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Vector3d p_P_m(1.2 + side(random), side(random), side(random));
    const HeadAngles head{side(random), side(random)};
    for (const geometry::LaserMount& laser : {rig.horizontal_laser, rig.vertical_laser}) {
      const bool horizontal = laser.normal_T.z() > 0.5;
      const auto turned = horizontal
                              ? TiltPlaneToPoint(p_P_m, laser.p_TLaser_m, laser.normal_T, head)
                              : PanPlaneToPoint(p_P_m, laser.p_TLaser_m, laser.normal_T, head);
      ASSERT_TRUE(turned);
      EXPECT_NEAR(laser.normal_T.dot(InHead(p_P_m, *turned) - laser.p_TLaser_m), 0.0, 1e-12);
      EXPECT_EQ(horizontal ? turned->pan_rad : turned->tilt_rad,
                horizontal ? head.pan_rad : head.tilt_rad);
      EXPECT_GT(InHead(p_P_m, *turned).x(), 0.0) << "the nearer of the two solutions looks forward";
    }
  }
}

TEST(TurnHeadTest, PointTooNearForThePlaneHasNoTurn) {
  const geometry::SensorRig rig = TestRig();
  const Eigen::Vector3d p_P_m(0.01, 0.0, 0.0);
  EXPECT_FALSE(
      TiltPlaneToPoint(p_P_m, rig.horizontal_laser.p_TLaser_m, rig.horizontal_laser.normal_T, {}));
  EXPECT_FALSE(
      PanPlaneToPoint(p_P_m, rig.vertical_laser.p_TLaser_m, rig.vertical_laser.normal_T, {}));
}

TEST(TurnHeadTest, AimedCameraHasThePointInItsMiddle) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> side(-0.6, 0.6);
  geometry::SensorRig rig = TestRig();
  // Also for a camera that does not quite look along the head's x axis.
  rig.X_TB.linear() = rig.X_TB.linear() * geometry::RotationAboutX(0.01) *
                      geometry::RotationAboutY(-0.02) * geometry::RotationAboutZ(0.015);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector3d p_P_m(1.4 + side(random), side(random), side(random));
    const auto head = AimCamera(p_P_m, rig.X_TB, {});
    ASSERT_TRUE(head);
    const Eigen::Vector3d p_B_m = rig.X_TB.inverse() * InHead(p_P_m, *head);
    EXPECT_GT(p_B_m.z(), 0.0);
    EXPECT_NEAR(p_B_m.x() / p_B_m.z(), 0.0, 1e-7);
    EXPECT_NEAR(p_B_m.y() / p_B_m.z(), 0.0, 1e-7);
  }
}

TEST(TurnHeadTest, CameraCannotAimAtAPointInsideTheHead) {
  EXPECT_FALSE(AimCamera({0.001, 0.0, 0.0}, TestRig().X_TB, {}));
}

}  // namespace
}  // namespace geon::active_vision
