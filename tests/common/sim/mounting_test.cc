#include "sim/mounting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

TEST(MountingTest, SameSeedSameRobot) {
  MountingErrorOptions fifth, sixth;
  fifth.individual = 5;
  sixth.individual = 6;
  const auto a = AsMounted(TestRig(), fifth), b = AsMounted(TestRig(), fifth),
             c = AsMounted(TestRig(), sixth);
  EXPECT_EQ(a.stripe_camera.fx_px, b.stripe_camera.fx_px);
  EXPECT_EQ(a.X_TB.matrix(), b.X_TB.matrix());
  EXPECT_NE(a.stripe_camera.fx_px, c.stripe_camera.fx_px);
}

TEST(MountingTest, ErrorsHaveTheStatedSize) {
  const geometry::SensorRig rig = TestRig();
  MountingErrorOptions options;
  double focal2 = 0, camera2_rad2 = 0, laser2_rad2 = 0;
  constexpr int kRobots = 400;
  for (int robot = 0; robot < kRobots; ++robot) {
    options.individual = robot;
    const geometry::SensorRig mounted = AsMounted(rig, options);
    focal2 += std::pow(mounted.stripe_camera.fx_px / 1600.0 - 1.0, 2) / kRobots;
    const Eigen::AngleAxisd turn(
        Eigen::Matrix3d(rig.X_TB.linear().transpose() * mounted.X_TB.linear()));
    camera2_rad2 += turn.angle() * turn.angle() / kRobots;
    const double laser_rad = std::acos(
        std::min(1.0, mounted.horizontal_laser.normal_T.dot(rig.horizontal_laser.normal_T)));
    laser2_rad2 += laser_rad * laser_rad / kRobots;
    EXPECT_EQ(mounted.X_TB.translation(), rig.X_TB.translation());
  }
  EXPECT_NEAR(std::sqrt(focal2) / options.focal_1, 1.0, 0.12);
  EXPECT_NEAR(std::sqrt(camera2_rad2 / 3) / options.camera_rad, 1.0, 0.12);
  // Turning about the normal itself does not move it.
  EXPECT_NEAR(std::sqrt(laser2_rad2 / 2) / options.laser_rad, 1.0, 0.12);
}

}  // namespace
}  // namespace geon::sim
