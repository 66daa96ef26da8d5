#include "mission/target_track.h"

#include <gtest/gtest.h>

#include "active_vision/turn_head.h"
#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

// A sighting whose bottommost pixel is the given point of the room.
HeadSighting Seeing(const geometry::SensorRig& rig, const geometry::RigidTransform& X_WR,
                    const Eigen::Vector3d& p_W_m) {
  HeadSighting sighting;
  sighting.X_WR = X_WR;
  sighting.still = true;
  const Eigen::Vector3d p_R_m = X_WR.inverse() * p_W_m;
  sighting.head =
      active_vision::AimCamera(rig.X_RP.inverse() * p_R_m, rig.X_TC, {0.0, -0.2}).value();
  const auto X_RC = rig.ColorCameraPose(sighting.head.pan_rad, sighting.head.tilt_rad);
  sighting.seen.target = attention::Blob{{10, 10, 20, 20}, 400, {20, 20}};
  sighting.seen.bottom_px = rig.color_camera.Project(X_RC.inverse() * p_R_m);
  return sighting;
}

// The same by the floor camera of a robot that stands where W begins.
FloorSighting SeeingByFloorCamera(const geometry::SensorRig& rig, const Eigen::Vector3d& p_W_m) {
  FloorSighting sighting;
  sighting.seen.target = attention::Blob{{10, 10, 20, 20}, 400, {20, 20}};
  sighting.seen.bottom_px = rig.floor_camera.Project(rig.X_RF.inverse() * p_W_m);
  return sighting;
}

class TargetTrackTest : public testing::Test {
 protected:
  geometry::SensorRig rig_ = SmallRig();
  TargetTrack track_{LookingOptions(), rig_};
  Eigen::Vector2d robot_W_m_ = Eigen::Vector2d::Zero();
};

TEST_F(TargetTrackTest, OneSightingLeavesBothHeightsOpenAndGoesToTheNearer) {
  track_.See(Seeing(rig_, geometry::PlanarPose(0, 0, 0), {2.5, 0.5, 0.0}));
  EXPECT_EQ(track_.Best()->support_height_m, 0.0);
  EXPECT_NEAR(track_.Best()->p_WFoot_m.x(), 2.5, 1e-6);
  EXPECT_EQ(track_.NearestLikely(robot_W_m_)->support_height_m, 0.7);
  EXPECT_LT(track_.NearestLikely(robot_W_m_)->p_WFoot_m.x(), 1.3);
}

TEST_F(TargetTrackTest, DrivingTellsTheHeightsApart) {
  for (const double height_m : {0.0, 0.7}) {
    track_.Clear();
    for (int i = 0; i < 5; ++i) {
      track_.See(Seeing(rig_, geometry::PlanarPose(0.15 * i, 0.0, 0.1), {2.5, 0.5, height_m}));
    }
    const SupportHypothesis* best = track_.NearestLikely(robot_W_m_);
    EXPECT_EQ(best->support_height_m, height_m);
    EXPECT_NEAR((best->p_WFoot_m - Eigen::Vector2d(2.5, 0.5)).norm(), 0.0, 0.02);
  }
}

TEST_F(TargetTrackTest, FloorBeyondTheSupposedDeskMeansNoDesk) {
  track_.See(Seeing(rig_, geometry::PlanarPose(0, 0, 0), {2.5, 0.0, 0.0}));
  FloorSighting floor;
  for (int i = 10; i >= -10; --i) {
    const Eigen::Vector2d direction(std::cos(0.05 * i), std::sin(0.05 * i));
    floor.columns.push_back({0.4 * direction, 2.4 * direction, true});
  }
  for (int i = 0; i < 3; ++i) track_.See(floor);
  EXPECT_EQ(track_.NearestLikely(robot_W_m_)->support_height_m, 0.0);
}

TEST_F(TargetTrackTest, ATargetThatMovedIsTrackedAnew) {
  for (int i = 0; i < 3; ++i) {
    track_.See(Seeing(rig_, geometry::PlanarPose(0, 0, 0), {2.5, 0.5, 0.0}));
  }
  for (int i = 0; i < 5; ++i) {
    track_.See(Seeing(rig_, geometry::PlanarPose(0, 0, 0), {2.0, -1.0, 0.0}));
  }
  EXPECT_NEAR((track_.Best()->p_WFoot_m - Eigen::Vector2d(2.0, -1.0)).norm(), 0.0, 0.1);
}

// A target that comes into the floor camera's picture from the side is first seen too far away. On
// a desk close below that camera this makes little difference.
TEST_F(TargetTrackTest, AHeightWhosePlaceWasWrongIsStillPossible) {
  const Eigen::Vector2d place_m(1.5, 0.0);
  track_.See(SeeingByFloorCamera(rig_, {3.2, 0.0, 0.0}));
  for (int i = 0; i < 6; ++i) {
    track_.See(SeeingByFloorCamera(rig_, {place_m.x(), place_m.y(), 0.0}));
  }
  ASSERT_GT(track_.hypotheses()[1].sightings, 5) << "the desk explains all of it";
  const SupportHypothesis& floor = track_.hypotheses()[0];
  EXPECT_NEAR((floor.p_WFoot_m - place_m).norm(), 0.0, 0.05);
  EXPECT_GT(floor.misfit_1, 30.0) << "but what speaks against it is not forgotten";
}

TEST_F(TargetTrackTest, RefutingAHeightLeavesTheOther) {
  track_.See(Seeing(rig_, geometry::PlanarPose(0, 0, 0), {2.0, 0.0, 0.0}));
  track_.Refute(0.0);
  EXPECT_EQ(track_.Best()->support_height_m, 0.7);
  track_.Clear();
  EXPECT_FALSE(track_.known());
}

TEST_F(TargetTrackTest, AFootThatIsOutOfThePictureTellsNothing) {
  HeadSighting sighting = Seeing(rig_, geometry::PlanarPose(0, 0, 0), {2.0, 0.0, 0.0});
  sighting.seen.touched.bottom = true;
  track_.See(sighting);
  EXPECT_FALSE(track_.known());
}

}  // namespace
}  // namespace geon::mission
