#include "config/rig_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/angles.h"
#include "config/daemon_arguments.h"

namespace geon::config {
namespace {

using geometry::SensorRig;
using ::testing::HasSubstr;

SensorRig InstalledRig() {
  Result<YamlDocument> document =
      LoadRobotFile(std::filesystem::path(GEON_SOURCE_DIR) / "scripts/config/robot.yaml", {"rig"});
  EXPECT_TRUE(document.ok()) << document.message();
  const SensorRig rig = ReadDrawnRig(document->root().Child("rig"));
  EXPECT_TRUE(document->Finish().ok()) << document->Finish().message();
  return rig;
}

TEST(RigConfigTest, FansHoldTheirLaserAndTheCrossingAndRunAlongTheirStripe) {
  const SensorRig rig = InstalledRig();
  const Eigen::Vector3d crossing_T = rig.X_TB * Eigen::Vector3d(0.0, 0.0, 1.037);
  for (const geometry::LaserMount& laser : {rig.horizontal_laser, rig.vertical_laser}) {
    EXPECT_NEAR(laser.normal_T.norm(), 1.0, 1e-12);
    EXPECT_NEAR(laser.normal_T.dot(crossing_T - laser.p_TLaser_m), 0.0, 1e-12);
  }
  EXPECT_NEAR(rig.horizontal_laser.normal_T.y(), 0.0, 1e-12);
  EXPECT_GT(rig.horizontal_laser.normal_T.z(), 0.9);
  EXPECT_NEAR(rig.vertical_laser.normal_T.z(), 0.0, 1e-12);
  EXPECT_GT(rig.vertical_laser.normal_T.y(), 0.9);
}

TEST(RigConfigTest, BothStripesStayInViewFromSeventyCentimetresToTwoMetres) {
  const SensorRig rig = InstalledRig();
  for (const double range_m : {0.7, 1.0, 1.037, 1.5, 2.0}) {
    // Where the fans meet the plane at this range straight ahead of the camera.
    const Eigen::Vector3d ahead_T = rig.X_TB * Eigen::Vector3d(0.0, 0.0, range_m);
    const auto& h = rig.horizontal_laser;
    const auto& v = rig.vertical_laser;
    const double z_m = h.normal_T.dot(h.p_TLaser_m - ahead_T) / h.normal_T.z();
    const double y_m = v.normal_T.dot(v.p_TLaser_m - ahead_T) / v.normal_T.y();
    EXPECT_LT(std::abs(rig.stripe_camera.fy_px * z_m / range_m), 94.0) << range_m;
    EXPECT_LT(std::abs(rig.stripe_camera.fx_px * y_m / range_m), 94.0) << range_m;
  }
}

TEST(RigConfigTest, CamerasLookForwardAndTheFloorCameraDown) {
  const SensorRig rig = InstalledRig();
  EXPECT_NEAR(rig.ColorCameraPose(0.0, 0.0).linear().col(2).z(), -std::sin(RadiansFromDegrees(15)),
              1e-12);
  EXPECT_NEAR(rig.X_RF.linear().col(2).z(), -std::sin(RadiansFromDegrees(40)), 1e-12);
  EXPECT_NEAR(rig.X_RF.linear().col(2).y(), 0.0, 1e-12);
  EXPECT_EQ(rig.stripe_camera.cx_px, 319.5);
  EXPECT_EQ(rig.floor_camera.cy_px, 119.5);
}

TEST(RigConfigTest, ErrorsNameTheLineOfTheRig) {
  const Result<YamlDocument> document = YamlDocument::Parse(
      "rig:\n  ptu: {position_m: [0, 0], pitch_down_deg: 15}\n"
      "  color_camera: {position_m: [0, 0, 0], width_px: 640, height_px: 480, focal_px: -1}\n"
      "  stripe_camera: {position_m: [0, 0, 0], width_px: 640, height_px: 480, focal_px: 1600}\n"
      "  horizontal_laser: {position_m: [1, 5, 0], crosses_axis_m: 1}\n"
      "  vertical_laser: {position_m: [0, 0.1, 0], crosses_axis_m: 1, color: red}\n",
      "robot.yaml");
  ReadDrawnRig(document->root().Child("rig"));
  const std::string message = document->Finish().message();
  EXPECT_THAT(message, HasSubstr("robot.yaml:2: 'position_m' must be a list of 3 finite numbers"));
  EXPECT_THAT(message, HasSubstr("robot.yaml:3: 'focal_px' must be positive"));
  EXPECT_THAT(message, HasSubstr("robot.yaml:5: 'position_m' leaves no plane"));
  EXPECT_THAT(message, HasSubstr("robot.yaml:6: 'color' is not a known key"));
  EXPECT_THAT(message, HasSubstr("'floor_camera' is missing"));
}

}  // namespace
}  // namespace geon::config
