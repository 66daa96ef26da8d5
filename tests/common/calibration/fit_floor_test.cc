#include "calibration/fit_floor.h"

#include <gtest/gtest.h>

#include "tests/common/calibration/synthetic_robot.h"

namespace geon::calibration {
namespace {

// Points of a floor z = lean_x x + lean_y y + height in R, over a fan-shaped patch.
std::vector<Eigen::Vector3d> Floor(double lean_x, double lean_y, double height_m) {
  std::vector<Eigen::Vector3d> p_R_m;
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, 0.001);
  for (int k = 0; k < 2000; ++k) {
    const double x = 0.7 + 0.4 * (k % 5) / 4.0 + 0.01 * (k % 7);
    const double y = -0.4 + 0.8 * (k % 101) / 100.0;
    p_R_m.emplace_back(x, y, height_m + lean_x * x + lean_y * y + noise(random));
  }
  return p_R_m;
}

TEST(FitFloor, FindsHowTheHeadStandsOverTheFloor) {
  const geometry::SensorRig rig = DrawnRig();
  const Result<FloorFit> fit = FitFloorPoints(Floor(0.01, -0.006, -0.004), rig);
  ASSERT_TRUE(fit.ok()) << fit.message();
  EXPECT_NEAR(fit->pitch_rad, 0.01, 2e-4);
  EXPECT_NEAR(fit->roll_rad, -0.006, 2e-4);
  EXPECT_NEAR(fit->height_m, 0.004, 4e-4);
  EXPECT_NEAR(fit->rms_m, 0.001, 2e-4);
  // In the new R the floor is z = 0, and nothing turned about the vertical.
  for (const Eigen::Vector3d& p_R : Floor(0.01, -0.006, -0.004)) {
    const Eigen::Vector3d p_new = fit->X_RP * rig.X_RP.inverse() * p_R;
    EXPECT_NEAR(p_new.z(), 0.0, 0.006);
  }
  EXPECT_TRUE(fit->X_RP.translation().head<2>().isApprox(rig.X_RP.translation().head<2>()) ||
              fit->X_RP.translation().head<2>().norm() < 1e-12);
}

TEST(FitFloor, ASkirtingBoardDoesNotLiftIt) {
  std::vector<Eigen::Vector3d> p_R_m = Floor(0.0, 0.0, 0.0);
  for (size_t k = 0; k < p_R_m.size(); k += 4) p_R_m[k].z() += 0.08;
  const Result<FloorFit> fit = FitFloorPoints(p_R_m, DrawnRig());
  ASSERT_TRUE(fit.ok());
  EXPECT_NEAR(fit->height_m, 0.0, 0.001);
}

TEST(FitFloor, RefusesTooFewPointsAndASingleLine) {
  EXPECT_FALSE(FitFloorPoints({}, DrawnRig()).ok());
  std::vector<Eigen::Vector3d> line;
  for (int k = 0; k < 500; ++k) line.emplace_back(1.0, -0.5 + 0.002 * k, 0.0);
  EXPECT_FALSE(FitFloorPoints(line, DrawnRig()).ok());
}

TEST(FitFloor, StripesAreMeasuredThroughTheRig) {
  // The synthetic robot as drawn, its head 1.2 m above a floor, pitched 15 degrees down.
  const geometry::SensorRig rig = DrawnRig();
  std::vector<FloorView> views;
  for (const double tilt_rad : {-0.6, -0.7, -0.8}) {
    for (const double pan_rad : {-0.3, 0.0, 0.3}) {
      FloorView view{pan_rad, tilt_rad, {}};
      const geometry::RigidTransform X_RT = rig.HeadPose(pan_rad, tilt_rad);
      const geometry::RigidTransform X_RB = X_RT * rig.X_TB;
      for (int k = 0; k < 60; ++k) {
        // Where the fan meets the floor straight before the head, then along the stripe.
        const Eigen::Vector3d normal_R = X_RT.linear() * rig.horizontal_laser.normal_T;
        const Eigen::Vector3d along_R = normal_R.cross(Eigen::Vector3d::UnitZ()).normalized();
        const Eigen::Vector3d origin_R = X_RT * rig.horizontal_laser.p_TLaser_m;
        const Eigen::Vector3d down_R = along_R.cross(normal_R);
        const Eigen::Vector3d foot_R = origin_R - down_R * (origin_R.z() / down_R.z());
        const Eigen::Vector3d p_B = X_RB.inverse() * (foot_R + (k - 30) * 0.008 * along_R);
        if (p_B.z() > 0.0) view.horizontal_px.push_back(rig.stripe_camera.Project(p_B));
      }
      views.push_back(view);
    }
  }
  const Result<FloorFit> fit = FitFloor(views, rig);
  ASSERT_TRUE(fit.ok()) << fit.message();
  EXPECT_NEAR(fit->height_m, 0.0, 1e-6);
  EXPECT_LT(fit->rms_m, 1e-6);
}

}  // namespace
}  // namespace geon::calibration
