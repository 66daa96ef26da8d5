#include "calibration/rig_unknowns.h"

#include <gtest/gtest.h>

#include "calibration/rig_model.h"
#include "tests/common/calibration/synthetic_robot.h"

namespace geon::calibration {
namespace {

RigUnknowns SomeUnknowns() {
  RigUnknowns unknowns;
  const auto sigmas = PriorSigmas({}, DrawnRig());
  for (int k = 0; k < RigUnknowns::kAll; ++k) {
    unknowns.at(k) = 0.5 * sigmas[static_cast<size_t>(k)] * (k % 3 - 1.2);
  }
  return unknowns;
}

TEST(RigUnknowns, ZeroIsTheDrawing) {
  const geometry::SensorRig drawn = DrawnRig();
  const geometry::SensorRig rig = RigFrom({}, drawn);
  EXPECT_TRUE(rig.X_TB.isApprox(drawn.X_TB));
  EXPECT_EQ(rig.stripe_camera.fx_px, drawn.stripe_camera.fx_px);
  EXPECT_TRUE(rig.vertical_laser.normal_T.isApprox(drawn.vertical_laser.normal_T));
}

TEST(RigUnknowns, EveryOneHasANameAndAPrior) {
  for (const UnknownName& name : UnknownNames()) EXPECT_FALSE(name.what.empty());
  for (const double sigma : PriorSigmas({}, DrawnRig())) EXPECT_GT(sigma, 0.0);
}

TEST(RigUnknowns, TheBundlesGeometryIsThatOfTheRig) {
  const geometry::SensorRig drawn = DrawnRig();
  const RigUnknowns unknowns = SomeUnknowns();
  const geometry::SensorRig rig = RigFrom(unknowns, drawn);
  const double angles[2] = {0.3, -0.4};
  const Eigen::Vector3d p_P(1.2, 0.35, -0.5);
  const double* axes = unknowns[RigUnknowns::kAxes];
  const Vector3<double> p_T = PointInHead(axes, angles, p_P);
  const geometry::RigidTransform X_PT = rig.X_RP.inverse() * rig.HeadPose(angles[0], angles[1]);
  EXPECT_TRUE(p_T.isApprox(X_PT.inverse() * p_P, 1e-12));

  const double* mount = unknowns[RigUnknowns::kStripeMount];
  const double* lens = unknowns[RigUnknowns::kStripeLens];
  const Vector3<double> p_B = PointInCamera(drawn.X_TB, mount, p_T);
  EXPECT_TRUE(p_B.isApprox(rig.X_TB.inverse() * p_T, 1e-12));
  const Eigen::Vector2d pixel_px = PixelOf(drawn.stripe_camera, lens, p_B);
  EXPECT_TRUE(pixel_px.isApprox(rig.stripe_camera.Project(p_B), 1e-12));
  EXPECT_TRUE(RayOf(drawn.stripe_camera, lens, pixel_px).isApprox(p_B / p_B.z(), 1e-9));
  EXPECT_TRUE(RayInHead(drawn.X_TB, mount, Vector3<double>(p_B)).isApprox(rig.X_TB.linear() * p_B));

  const LaserAxes laser_axes = AxesOf(drawn.horizontal_laser);
  EXPECT_NEAR(
      HeightOverFan(drawn.horizontal_laser, laser_axes, unknowns[RigUnknowns::kHorizontal], p_T),
      rig.horizontal_laser.normal_T.dot(p_T - rig.horizontal_laser.p_TLaser_m), 1e-12);
}

TEST(RigUnknowns, ALaserTurnsAboutItsBeamAndItsStripe) {
  const LaserAxes axes = AxesOf(DrawnRig().horizontal_laser);
  EXPECT_NEAR(std::abs(axes.stripe_T.y()), 1.0, 1e-9);
  EXPECT_GT(axes.beam_T.x(), 0.9);
  EXPECT_NEAR(axes.beam_T.dot(DrawnRig().horizontal_laser.normal_T), 0.0, 1e-12);
}

TEST(RigUnknowns, TolerancesMustBePositive) {
  DrawingTolerances tolerances;
  EXPECT_TRUE(tolerances.Validate().ok());
  tolerances.axis_m = 0.0;
  EXPECT_FALSE(tolerances.Validate().ok());
}

}  // namespace
}  // namespace geon::calibration
