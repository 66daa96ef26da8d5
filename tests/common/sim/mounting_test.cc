#include "sim/mounting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/angles.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

TEST(MountingTest, SameSeedSameRobot) {
  MountingErrorOptions fifth, sixth;
  fifth.individual = 5;
  sixth.individual = 6;
  const auto a = AsBuilt(TestRig(), fifth), b = AsBuilt(TestRig(), fifth),
             c = AsBuilt(TestRig(), sixth);
  EXPECT_EQ(a.stripe_camera.ideal.fx_px, b.stripe_camera.ideal.fx_px);
  EXPECT_EQ(a.X_TB.matrix(), b.X_TB.matrix());
  EXPECT_EQ(a.tilt_zero_rad, b.tilt_zero_rad);
  EXPECT_NE(a.stripe_camera.ideal.fx_px, c.stripe_camera.ideal.fx_px);
}

TEST(MountingTest, WithoutErrorsTheRobotIsItsDrawing) {
  const geometry::SensorRig rig = TestRig();
  const BuiltRig built = AsBuilt(rig, NoMountingErrors());
  for (const auto& [pan_rad, tilt_rad] : {std::pair{0.0, 0.0}, {0.7, -0.4}, {-1.1, 0.2}}) {
    EXPECT_TRUE(built.StripeCameraPose(pan_rad, tilt_rad)
                    .isApprox(rig.StripeCameraPose(pan_rad, tilt_rad), 1e-12));
    EXPECT_TRUE(built.ColorCameraPose(pan_rad, tilt_rad)
                    .isApprox(rig.ColorCameraPose(pan_rad, tilt_rad), 1e-12));
  }
  const Eigen::Vector3d p_C_m(0.15, -0.1, 1.2);
  EXPECT_EQ(built.stripe_camera.Project(p_C_m), rig.stripe_camera.Project(p_C_m));
  EXPECT_EQ(built.horizontal_laser.normal_T, rig.horizontal_laser.normal_T);
  EXPECT_NEAR(built.vertical_laser.forward_T.dot(rig.vertical_laser.normal_T), 0.0, 1e-12);
}

TEST(MountingTest, ErrorsHaveTheStatedSize) {
  const geometry::SensorRig rig = TestRig();
  MountingErrorOptions options;
  std::vector<std::vector<double>> errors(10);  // in units of what is stated; one list for each
  constexpr int kRobots = 400;
  double corner_px = 0.0;
  for (int robot = 0; robot < kRobots; ++robot) {
    options.individual = robot;
    const BuiltRig built = AsBuilt(rig, options);
    const BuiltCamera& camera = built.stripe_camera;
    const auto note = [&](size_t list, double error) { errors[list].push_back(error); };
    note(0, (camera.ideal.fy_px / 1600.0 - 1.0) / options.focal_1);
    note(1, (camera.ideal.fx_px / camera.ideal.fy_px - 1.0) / options.aspect_1);
    note(2, (camera.ideal.cx_px - 319.5) / options.principal_px);
    const Eigen::AngleAxisd turn(
        Eigen::Matrix3d(rig.X_TB.linear().transpose() * built.X_TB.linear()));
    note(3, turn.angle() * turn.axis().x() / options.camera_rad);
    note(4, (built.X_TB.translation() - rig.X_TB.translation()).y() / options.camera_m);
    const Eigen::Vector3d& normal_T = rig.horizontal_laser.normal_T;
    note(5, normal_T.cross(built.horizontal_laser.normal_T).y() / options.laser_rad);
    note(6,
         (built.vertical_laser.p_TLaser_m - rig.vertical_laser.p_TLaser_m).z() / options.laser_m);
    note(7, built.tilt_P.direction.z() / options.axes_rad);
    note(8, built.tilt_P.point_m.x() / options.axes_m);
    note(9, built.pan_zero_rad / options.zero_rad);
    const Eigen::Vector2d corner(0.0, 0.0);
    corner_px += (camera.lens.Ideal(corner) - corner).norm() / kRobots;
  }
  for (size_t list = 0; list < errors.size(); ++list) {
    double squares = 0.0;
    for (const double error : errors[list]) squares += error * error / kRobots;
    EXPECT_NEAR(std::sqrt(squares), 1.0, 0.12) << list;
  }
  EXPECT_NEAR(corner_px, options.lens_px, 0.1);
}

TEST(MountingTest, ZeroOffsetsTurnTheHeadFurtherThanItCounts) {
  BuiltRig built = AsBuilt(TestRig(), NoMountingErrors());
  built.pan_zero_rad = 0.01;
  built.tilt_zero_rad = -0.02;
  const BuiltRig drawn = AsBuilt(TestRig(), NoMountingErrors());
  EXPECT_TRUE(built.HeadPose(0.3, 0.1).isApprox(drawn.HeadPose(0.31, 0.08), 1e-12));
}

TEST(MountingTest, TurningAboutALineLeavesTheLineWhereItIs) {
  const TurnAxis axis{{0.1, 0.2, 0.3}, Eigen::Vector3d(1, 2, -1).normalized()};
  const geometry::RigidTransform turn = axis.Turn(0.8);
  const Eigen::Vector3d on_axis = axis.point_m + 0.7 * axis.direction;
  EXPECT_NEAR((turn * on_axis - on_axis).norm(), 0.0, 1e-12);
  EXPECT_NEAR(Eigen::AngleAxisd(turn.linear()).angle(), 0.8, 1e-12);
}

}  // namespace
}  // namespace geon::sim
