#include "rangefinder/color_tags.h"

#include <gtest/gtest.h>

#include "base/contracts.h"
#include "tests/common/active_vision/test_rig.h"

namespace geon::rangefinder {
namespace {

constexpr double kPan_rad = 0.1;
constexpr double kTilt_rad = -0.3;

sensor::ScanPlan Plan() {
  sensor::ScanPlan plan;
  plan.scan_id = 5;
  plan.pan_rad = kPan_rad;
  plan.tilt_rad = kTilt_rad;
  plan.support_height_m = 0.1;
  return plan;
}

// The target fills the box but for its left half of the upper row of 20 pixels.
sensor::TargetMask Mask() {
  sensor::TargetMask mask;
  mask.scan_id = 5;
  mask.box = {300, 200, 40, 40};
  mask.pan_rad = kPan_rad;
  mask.tilt_rad = kTilt_rad;
  for (int v = 0; v < 20; ++v) mask.runs_px.insert(mask.runs_px.end(), {20, 20});
  mask.runs_px.insert(mask.runs_px.end(), {0, 800});
  return mask;
}

// A profile of one point: 1.2 m before the colour camera, at this place of its picture.
sensor::RangeProfile PointAt(const geometry::SensorRig& rig, double u_px, double v_px) {
  const geometry::RigidTransform X_LR =
      geometry::LevelFrame(rig.StripeCameraPose(kPan_rad, kTilt_rad), 0.1).inverse();
  sensor::RangeProfile profile;
  profile.pixel = {1};
  profile.p_L_m = {X_LR * rig.ColorCameraPose(kPan_rad, kTilt_rad) *
                   (1.2 * rig.color_camera.Ray(u_px, v_px))};
  return profile;
}

double TagAt(double u_px, double v_px, int edge_px = 3) {
  const geometry::SensorRig rig = active_vision::TestRig();
  sensor::RangeProfile profile = PointAt(rig, u_px, v_px);
  TagColors(Mask(), Plan(), rig, &profile, edge_px);
  return profile.on_color_1.at(0);
}

TEST(TagColors, TellsTheMaskWhereThePointStandsInTheColourCamera) {
  EXPECT_EQ(TagAt(330, 210), 1.0);
  EXPECT_EQ(TagAt(310, 210), 0.0);
  EXPECT_EQ(TagAt(310, 230), 1.0);
  EXPECT_EQ(TagAt(250, 230), 0.0);  // outside the box
}

TEST(TagColors, IsUnsureAtTheEdge) {
  EXPECT_NEAR(TagAt(320, 210), 4.0 / 7.0, 1e-9);
  EXPECT_NEAR(TagAt(339, 230), 4.0 / 7.0, 1e-9);
  EXPECT_NEAR(TagAt(341, 230), 2.0 / 7.0, 1e-9);
  EXPECT_EQ(TagAt(341, 230, 0), 0.0);
}

TEST(TagColors, DoesNotKnowWhatTheColourCameraDoesNotSee) {
  EXPECT_EQ(TagAt(-40, 230), 0.5);
  const geometry::SensorRig rig = active_vision::TestRig();
  sensor::RangeProfile behind = PointAt(rig, 320, 240);
  behind.p_L_m[0] = Eigen::Vector3d(-3.0, 0.0, 0.5);
  TagColors(Mask(), Plan(), rig, &behind);
  EXPECT_EQ(behind.on_color_1.at(0), 0.5);
}

TEST(TagColors, RefusesAMaskThatDoesNotFit) {
  const geometry::SensorRig rig = active_vision::TestRig();
  sensor::RangeProfile profile = PointAt(rig, 320, 240);
  sensor::TargetMask other = Mask();
  other.scan_id = 6;
  EXPECT_THROW(TagColors(other, Plan(), rig, &profile), ContractViolation);
  sensor::TargetMask holes = Mask();
  holes.runs_px.pop_back();
  EXPECT_THROW(TagColors(holes, Plan(), rig, &profile), ContractViolation);
}

}  // namespace
}  // namespace geon::rangefinder
