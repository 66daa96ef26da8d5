#include "navigation/floor_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "base/angles.h"
#include "tests/common/navigation/floor_picture.h"

namespace geon::navigation {
namespace {

const cv::Vec3b kWall(160, 160, 160);  // white in the floor's brightness

TEST(LearnFloorTest, LearnsTheShadeOfTheRoomsLight) {
  const cv::Vec3b warm(100, 120, 126);
  const auto model = LearnFloor(Picture([&](double, double) { return warm; }), kCamera,
                                CameraPose(), kModel, FloorPatch());
  ASSERT_TRUE(model.has_value());
  EXPECT_NEAR(model->level, 115.3, 0.5);
  EXPECT_NEAR(model->red_share_1, 126.0 / 346.0, 0.002);
}

TEST(LearnFloorTest, AMottledFloorIsKnownByAWiderTolerance) {
  const auto mottled = [](double x_m, double y_m) {
    const bool warm =
        (static_cast<int>(50.0 * x_m) + static_cast<int>(50.0 * (y_m + 5.0))) % 2 == 0;
    return warm ? cv::Vec3b(136, 150, 154) : cv::Vec3b(144, 150, 146);
  };
  const auto model = LearnFloor(Picture(mottled), kCamera, CameraPose(), kModel, FloorPatch());
  ASSERT_TRUE(model.has_value());
  EXPECT_GT(model->share_tolerance_1, 1.05 * kModel.share_tolerance_1);
}

TEST(LearnFloorTest, DoesNotTakeWhatStandsInFrontForFloor) {
  const auto red = Picture([](double, double) { return cv::Vec3b(30, 30, 180); });
  EXPECT_FALSE(LearnFloor(red, kCamera, CameraPose(), kModel, FloorPatch()).has_value());
  const auto half =
      Picture([](double x_m, double) { return x_m > 0.7 ? cv::Vec3b(60, 60, 60) : kFloor; });
  EXPECT_FALSE(LearnFloor(half, kCamera, CameraPose(), kModel, FloorPatch()).has_value());
}

TEST(LearnFloorTest, APatchThatIsNotInThePictureTeachesNothing) {
  const auto floor = Picture([](double, double) { return kFloor; });
  EXPECT_FALSE(LearnFloor(floor, kCamera, CameraPose(), kModel, {-2.0, -1.0, -0.2, 0.2}));
}

TEST(LearnFloorTest, BesideAWallItLearnsFromWhatIsLeftOfTheFloor) {
  const cv::Vec3b warm(100, 120, 126);
  const auto wall_on_the_left =
      Picture([&](double, double y_m) { return y_m > 0.05 ? kWall : warm; });
  const auto learn = [&](const cv::Mat& picture, const RingEchoes& echoes) {
    return LearnFloor(picture, kCamera, CameraPose(), kModel, echoes);
  };
  const auto beside = learn(wall_on_the_left, {});
  ASSERT_TRUE(beside.has_value());
  EXPECT_NEAR(beside->level, 115.3, 1.0);

  const auto wall_ahead = Picture([&](double x_m, double) { return x_m > 0.66 ? kWall : warm; });
  const auto before = learn(wall_ahead, {{{0.66, 0.0}}, 0.0});
  ASSERT_TRUE(before.has_value());
  EXPECT_NEAR(before->level, 115.3, 1.0);

  const auto all_wall = Picture([](double, double) { return kWall; });
  EXPECT_FALSE(learn(all_wall, {{{0.42, 0.0}}, 0.0})) << "infrared feels it";
  EXPECT_FALSE(learn(wall_ahead, {{}, 0.5})) << "what was heard then says nothing of now";
}

TEST(LearnFloorTest, HalfWallHalfFloorIsNoFloorOfAWiderTolerance) {
  const auto half = Picture([](double, double y_m) {
    return y_m > 0.0 ? cv::Vec3b(146, 152, 148) : cv::Vec3b(156, 148, 144);
  });
  EXPECT_FALSE(LearnFloor(half, kCamera, CameraPose(), kModel, FloorPatch()).has_value());
}

class LearnOtherLightTest : public testing::Test {
 protected:
  // The floor that is known, and before the robot, from `from_m` on, what looks like this.
  static auto Learn(const cv::Vec3b& known, const cv::Vec3b& ahead, double from_m,
                    const RingEchoes& echoes = {}) {
    const FloorModel model =
        FloorModel::OfColor({double(known[2]), double(known[1]), double(known[0])});
    return LearnOtherLight(
        Picture([&](double x_m, double) { return x_m > from_m ? ahead : known; }), kCamera,
        CameraPose(), model, kModel, echoes);
  }

  const cv::Vec3b sun_{250, 240, 228};
  const cv::Vec3b shade_{124, 133, 133};
};

TEST_F(LearnOtherLightTest, LearnsTheShadeFromTheSunAndTheSunFromTheShade) {
  for (const bool known_in_sun : {true, false}) {
    const cv::Vec3b known = known_in_sun ? sun_ : shade_;
    const cv::Vec3b other = known_in_sun ? shade_ : sun_;
    const auto lights = Learn(known, other, 0.55);
    ASSERT_TRUE(lights.has_value());
    EXPECT_NEAR((*lights)[0].level, 130.0, 1.0);
    EXPECT_NEAR((*lights)[1].level, 239.3, 1.0);
    const auto picture = Picture([&](double x_m, double) { return x_m > 0.55 ? other : known; });
    EXPECT_EQ(cv::countNonZero(NotFloorMask(picture, *lights)), 0);
  }
}

TEST_F(LearnOtherLightTest, AWhiteWallInTheShadeStaysAnObstacle) {
  const auto lights = Learn(shade_, sun_, 0.55);
  ASSERT_TRUE(lights.has_value());
  const cv::Mat wall(20, 20, CV_8UC3, cv::Scalar(159, 155, 154));
  EXPECT_EQ(cv::countNonZero(NotFloorMask(wall, *lights)), 400);
}

TEST_F(LearnOtherLightTest, TheDarkSideOfABoxIsNoShadeWhereNoSunShines) {
  const cv::Vec3b by_a_warm_lamp(132, 161, 172), box(66, 81, 86);
  EXPECT_FALSE(Learn(by_a_warm_lamp, box, 0.55)) << "what it lacks is lamp light";
  const cv::Vec3b by_a_cold_lamp(164, 148, 136), bluish_box(91, 76, 70);
  EXPECT_FALSE(Learn(by_a_cold_lamp, bluish_box, 0.55)) << "no light has its colour";
}

TEST_F(LearnOtherLightTest, WhatStandsThereIsNoOtherLight) {
  EXPECT_FALSE(Learn(shade_, {64, 53, 51}, 0.55)) << "a dark box, bluer than the sun makes floor";
  EXPECT_FALSE(Learn(shade_, {30, 30, 220}, 0.55)) << "a red one";
  EXPECT_FALSE(Learn(shade_, {159, 155, 154}, 0.55)) << "hardly brighter: a wall";
  EXPECT_FALSE(Learn(sun_, shade_, 0.55, {{{0.55, 0.0}}, 0.0})) << "something answers there";
  EXPECT_FALSE(Learn(sun_, shade_, 0.84)) << "too little of it is seen";
}

TEST(PatchIsFreeTest, AWallBeforeTheRobotIsNotLearnedAsFloor) {
  const FloorPatch patch;  // 0.45 to 0.85 m ahead, 0.2 m to each side
  EXPECT_TRUE(PatchIsFree({}, patch));
  const auto free = [&](double distance_m, double bearing_rad, double moved_m = 0.0) {
    const Eigen::Vector2d echo_m(distance_m * std::cos(bearing_rad),
                                 distance_m * std::sin(bearing_rad));
    return PatchIsFree({{echo_m}, moved_m}, patch);
  };
  EXPECT_FALSE(free(0.8, 0.0));
  EXPECT_TRUE(free(0.9, 0.0));
  EXPECT_FALSE(free(0.9, 0.0, 0.1)) << "it may be nearer by now";
  EXPECT_FALSE(free(0.7, kPi / 4)) << "a slanting wall answers along its normal";
  EXPECT_TRUE(free(0.8, kPi / 4));
  EXPECT_TRUE(free(0.3, kPi / 2)) << "a wall beside the robot leaves the patch free";
  EXPECT_TRUE(free(0.3, kPi)) << "and so does one behind";
}

TEST(PatchIsFreeTest, APatchBesideCountsFromItsOwnEdges) {
  const FloorPatch left{0.45, 0.75, 0.0, 0.3};
  EXPECT_FALSE(PatchIsFree({{{0.0, 0.28}}, 0.0}, left));
  EXPECT_TRUE(PatchIsFree({{{0.0, -0.05}}, 0.0}, left));
}

}  // namespace
}  // namespace geon::navigation
