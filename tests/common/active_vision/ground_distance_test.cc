#include "active_vision/ground_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/common/active_vision/test_rig.h"

namespace geon::active_vision {
namespace {

TEST(GroundDistanceTest, AgreesWithThePrintedFormulasForALevelMount) {
  geometry::SensorRig rig = TestRig(0.0);
  rig.X_TC.translation().setZero();  // the formulas put the camera on the axes
  const double view_rad = 2.0 * std::atan(240.0 / 1600.0);
  for (const double depression_deg : {30.0, 45.0, 55.0}) {
    for (const double k_px : {0.0, 100.0, 240.0, 400.0}) {  // from the bottom of the image
      const double phi_rad = RadiansFromDegrees(depression_deg);
      const double v_px = 479.5 - k_px;
      const auto foot = LocateTargetFoot(rig, {0.0, -phi_rad}, {319.5, v_px}, 0.0);
      ASSERT_TRUE(foot);
      // (4.28) with theta as (4.29) prints it, and derived.
      const double printed_rad = k_px / 480.0 * view_rad;
      const double derived_rad = view_rad / 2.0 - std::atan((v_px - 239.5) / 1600.0);
      const auto distance_m = [&](double theta_rad) {
        return 1.2 * std::tan((kPi / 2.0 - phi_rad) - view_rad / 2.0 + theta_rad);
      };
      EXPECT_NEAR(foot->distance_from_robot_m, distance_m(derived_rad), 1e-9);
      EXPECT_NEAR(foot->distance_from_robot_m, distance_m(printed_rad),
                  0.005 * foot->distance_from_robot_m);
    }
  }
}

TEST(GroundDistanceTest, FindsAKnownFootFromAPitchedPannedHeadOnAnySupport) {
  const geometry::SensorRig rig = TestRig();
  for (const double support_m : {0.0, 0.7}) {
    for (const double pan_rad : {-0.5, 0.0, 0.4}) {
      for (const double bearing_rad : {-0.05, 0.05}) {
        const double bearing_R_rad = pan_rad + bearing_rad;
        const Eigen::Vector3d p_R_m(1.05 * std::cos(bearing_R_rad), 1.05 * std::sin(bearing_R_rad),
                                    support_m);
        const HeadAngles head{pan_rad, RadiansFromDegrees(support_m > 0.0 ? -12.0 : -32.0)};
        const Eigen::Vector2d pixel_px = rig.color_camera.Project(
            rig.ColorCameraPose(head.pan_rad, head.tilt_rad).inverse() * p_R_m);
        const auto foot = LocateTargetFoot(rig, head, pixel_px, support_m);
        ASSERT_TRUE(foot);
        EXPECT_NEAR((foot->p_R_m - p_R_m).norm(), 0.0, 1e-9);
        EXPECT_NEAR(foot->distance_from_robot_m, 1.05, 1e-9);
        EXPECT_NEAR(foot->bearing_rad, bearing_R_rad, 1e-9);
        const Eigen::Vector3d p_RB_m =
            rig.StripeCameraPose(head.pan_rad, head.tilt_rad).translation();
        EXPECT_NEAR(foot->distance_from_camera_m, (p_R_m - p_RB_m).head<2>().norm(), 1e-9);
      }
    }
  }
}

TEST(GroundDistanceTest, RayAboveTheHorizonMeetsNoGround) {
  const geometry::SensorRig rig = TestRig();
  EXPECT_FALSE(LocateTargetFoot(rig, {0.0, RadiansFromDegrees(30.0)}, {319.5, 239.5}, 0.0));
  EXPECT_FALSE(LocateTargetFoot(rig, {0.0, RadiansFromDegrees(-30.0)}, {319.5, 239.5}, 1.5))
      << "a support above the camera";
}

}  // namespace
}  // namespace geon::active_vision
