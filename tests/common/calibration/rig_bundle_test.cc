#include "calibration/rig_bundle.h"

#include <gtest/gtest.h>

#include "tests/common/calibration/synthetic_robot.h"

namespace geon::calibration {
namespace {

// The range that the rig gives to what the robot sees at `depth` in a fan.
double RangeError(const SyntheticRobot& robot, const geometry::SensorRig& rig, bool horizontal,
                  double line_px, double depth) {
  const Eigen::Vector2d seen_px = robot.SeenInFan(horizontal, line_px, depth);
  const Eigen::Vector3d ray_T = rig.X_TB.linear() * rig.stripe_camera.Ray(seen_px.x(), seen_px.y());
  const geometry::LaserMount& laser = horizontal ? rig.horizontal_laser : rig.vertical_laser;
  return laser.normal_T.dot(laser.p_TLaser_m - rig.X_TB.translation()) / laser.normal_T.dot(ray_T) -
         depth;
}

double WorstRangeError(const SyntheticRobot& robot, const geometry::SensorRig& rig, double depth) {
  double worst_m = 0.0;
  for (const bool horizontal : {true, false}) {
    for (const double line_px : {60.0, 240.0, 420.0}) {
      worst_m = std::max(worst_m, std::abs(RangeError(robot, rig, horizontal, line_px, depth)));
    }
  }
  return worst_m;
}

TEST(RigBundle, PerfectPicturesGiveBackTheRobot) {
  SyntheticRobot robot;
  robot.corner_noise = robot.stripe_noise = 0.0;
  const RigObservations observations = LookAround(robot, 3, 4, 3, 1);
  const Result<Bundle> bundle = AdjustRig(observations, DrawnRig());
  ASSERT_TRUE(bundle.ok()) << bundle.message();
  const geometry::SensorRig rig = RigFrom(bundle->unknowns, DrawnRig());
  EXPECT_NEAR(rig.stripe_camera.fx_px, robot.bw.f, 0.2);
  EXPECT_NEAR(rig.color_camera.fx_px, robot.color.f, 0.2);
  for (const double depth : {0.7, 1.0, 1.5, 2.0}) {
    EXPECT_LT(WorstRangeError(robot, rig, depth), 1e-4 * depth) << depth;
  }
  for (const Residuals& residuals : bundle->residuals) {
    EXPECT_GT(residuals.count, 100);
    EXPECT_LT(residuals.rms_px, 0.002);
  }
}

TEST(RigBundle, NoisyPicturesMeasureToHalfAMillimetreAtOneMetre) {
  for (const uint64_t seed : {1U, 2U}) {
    const SyntheticRobot robot;
    const Result<Bundle> bundle = AdjustRig(LookAround(robot, 5, 4, 3, seed), DrawnRig());
    ASSERT_TRUE(bundle.ok()) << bundle.message();
    const geometry::SensorRig rig = RigFrom(bundle->unknowns, DrawnRig());
    EXPECT_LT(WorstRangeError(robot, rig, 1.0), 0.0005) << "seed " << seed;
    for (const double depth : {0.7, 1.5, 2.0}) {
      EXPECT_LT(WorstRangeError(robot, rig, depth), 0.0015) << "seed " << seed << ", " << depth;
    }
    EXPECT_NEAR(bundle->residuals[0].rms_px, robot.corner_noise, 0.003);
    EXPECT_NEAR(bundle->residuals[2].rms_px, robot.stripe_noise, 0.008);
  }
}

}  // namespace
}  // namespace geon::calibration
