#include "calibration/calibrate_rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/calibration/synthetic_robot.h"

namespace geon::calibration {
namespace {

using testing::HasSubstr;

std::string Refusal(const RigObservations& observations) {
  const Result<RigCalibration> result = CalibrateRig(observations, DrawnRig());
  return result.ok() ? "accepted" : result.message();
}

TEST(CalibrateRig, SaysHowWellEveryRangeIsKnown) {
  const RigObservations observations = LookAround(SyntheticRobot(), 3, 4, 3, 1);
  const Result<RigCalibration> found = CalibrateRig(observations, DrawnRig());
  ASSERT_TRUE(found.ok()) << found.message();
  EXPECT_GT(found->views, 25);
  EXPECT_LE(found->views, 36);
  ASSERT_EQ(found->range_sigmas.size(), 8U);
  for (const RangeSigma& range : found->range_sigmas) {
    EXPECT_GT(range.sigma_m, 1e-5) << range.distance_m;
    EXPECT_LT(range.sigma_m, 0.001 * range.distance_m * range.distance_m) << range.distance_m;
  }
  EXPECT_NEAR(found->baseline_scale_1, 1.0, 0.015);
  EXPECT_FALSE(found->floor.has_value());
  ASSERT_EQ(found->stop_distances_m.size(), 3U);
  EXPECT_NEAR(found->stop_distances_m[2], 1.75, 0.02);
}

TEST(CalibrateRig, NamesWhatTheDrawingTellsBetterThanThePictures) {
  // Somebody knows the lens's k2 well, so that the pictures add nothing.
  CalibrationOptions options;
  options.bundle.tolerances.k2_1 = 0.01;
  const RigObservations observations = LookAround(SyntheticRobot(), 2, 4, 3, 1);
  const Result<RigCalibration> found = CalibrateRig(observations, DrawnRig(), options);
  ASSERT_TRUE(found.ok()) << found.message();
  std::vector<std::string> weak;
  for (const int k : found->weak) weak.push_back(UnknownNames()[static_cast<size_t>(k)].what);
  EXPECT_THAT(weak, testing::Contains(HasSubstr("distortion k2")));
  EXPECT_THAT(weak, testing::Not(testing::Contains(HasSubstr("focal length"))));
}

TEST(CalibrateRig, RefusesABoardThatWasNotSeen) {
  RigObservations observations = LookAround(SyntheticRobot(), 2, 3, 3, 1);
  for (BoardView& view : observations.views) view.stripe_corners_px.clear();
  EXPECT_THAT(Refusal(observations), HasSubstr("the board was not seen"));
}

TEST(CalibrateRig, RefusesTooFewPosesAndStops) {
  EXPECT_THAT(Refusal(LookAround(SyntheticRobot(), 1, 5, 3, 1)), HasSubstr("from 1 stop"));
  RigObservations observations = LookAround(SyntheticRobot(), 2, 3, 3, 1);
  observations.views.resize(11);
  EXPECT_THAT(Refusal(observations), HasSubstr("too few poses"));
}

TEST(CalibrateRig, RefusesStopsAtOneDistance) {
  RigObservations observations = LookAround(SyntheticRobot(), 5, 4, 3, 1);
  std::erase_if(observations.views, [](const BoardView& view) { return view.stop < 3; });
  EXPECT_THAT(Refusal(observations), HasSubstr("at about one distance"));
}

TEST(CalibrateRig, RefusesSquaresOfAnotherSize) {
  SyntheticRobot robot;
  robot.square = 0.022;
  const std::string refusal = Refusal(LookAround(robot, 3, 3, 3, 1));
  EXPECT_THAT(refusal, HasSubstr("the squares have another size than said"));
  EXPECT_THAT(refusal, testing::ContainsRegex("about 2[12]\\.[0-9] mm each would fit"));
}

TEST(CalibrateRig, RefusesALaserThatWasNotLit) {
  RigObservations observations = LookAround(SyntheticRobot(), 3, 3, 3, 1);
  for (BoardView& view : observations.views) view.vertical_px.clear();
  EXPECT_THAT(Refusal(observations), HasSubstr("the vertical laser left 0 points"));
}

TEST(CalibrateRig, RefusesAnglesOfOtherPictures) {
  RigObservations observations = LookAround(SyntheticRobot(), 3, 3, 3, 1);
  for (BoardView& view : observations.views) std::swap(view.pan_rad, view.tilt_rad);
  CalibrationOptions options;
  options.bundle.iterations = 10;
  EXPECT_FALSE(CalibrateRig(observations, DrawnRig(), options).ok());
}

}  // namespace
}  // namespace geon::calibration
