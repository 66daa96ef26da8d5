#include "mission/eyes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "base/contracts.h"
#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

constexpr int64_t kNow = 1'600'000'000'000'000;

sensor::Image Plain(int width_px, int height_px, uint8_t blue, uint8_t green, uint8_t red) {
  sensor::Image image;
  image.utime = kNow;
  image.width_px = width_px;
  image.height_px = height_px;
  image.row_stride_bytes = 3 * width_px;
  image.format = sensor::PixelFormat::kBgr8;
  for (int i = 0; i < width_px * height_px; ++i) {
    image.data.insert(image.data.end(), {blue, green, red});
  }
  return image;
}

constexpr int kWide_px = 160, kHigh_px = 120;

// On grey, red squares of this half width with these middles.
sensor::Image RedSquares(const std::vector<std::pair<Eigen::Vector2d, int>>& squares) {
  sensor::Image image = Plain(kWide_px, kHigh_px, 150, 150, 140);
  for (const auto& [middle_px, half_px] : squares) {
    for (int v = -half_px; v <= half_px; ++v) {
      for (int u = -half_px; u <= half_px; ++u) {
        const int x_px = static_cast<int>(std::lround(middle_px.x())) + u;
        const int y_px = static_cast<int>(std::lround(middle_px.y())) + v;
        if (x_px < 0 || y_px < 0 || x_px >= kWide_px || y_px >= kHigh_px) continue;
        uint8_t* pixel = &image.data[static_cast<size_t>(3 * (y_px * kWide_px + x_px))];
        pixel[0] = pixel[1] = 40;
        pixel[2] = 150;
      }
    }
  }
  return image;
}

class EyesTest : public testing::Test {
 protected:
  void Base(int64_t utime) {
    sensor::BaseState base;
    base.utime = utime;
    base.status = sensor::DeviceStatus::kReady;
    history_.Add(base);
  }
  void Ptu(int64_t utime) {
    sensor::PtuState ptu;
    ptu.utime = utime;
    ptu.status = sensor::DeviceStatus::kReady;
    history_.Add(ptu);
  }
  // The middle of what is seen in a picture of the head, taken from the origin, looking straight
  // on.
  std::optional<Eigen::Vector2d> HeadSees(sensor::Image image,
                                          std::optional<attention::TargetSighting> seen = {}) {
    eyes_.TakeHead(std::move(image), std::move(seen));
    Base(kNow - 10'000);
    Ptu(kNow - 10'000);
    Base(kNow + 100'000);
    Ptu(kNow + 100'000);
    const auto sighting = eyes_.LookHead(history_);
    EXPECT_TRUE(sighting.has_value());
    if (!sighting || !sighting->seen.target) return std::nullopt;
    return sighting->seen.target->center_px;
  }
  // A place of the room that the head's camera shows at a pixel, so far away.
  static Eigen::Vector3d Place(const Eigen::Vector2d& pixel_px, double away_m) {
    const geometry::SensorRig rig = SmallRig();
    const Eigen::Vector3d ray =
        rig.color_camera.Ray(pixel_px.x(), pixel_px.y()).normalized() * away_m;
    return rig.ColorCameraPose(0.0, 0.0) * ray;
  }
  const Eigen::Vector2d left_px_{40.0, 60.0}, right_px_{120.0, 60.0};
  PoseHistory history_;
  Eyes eyes_{FastOptions().seeing, SmallRig()};
};

TEST_F(EyesTest, APictureWaitsForItsPoseAndIsGivenOnce) {
  eyes_.TakeHead(Plain(160, 120, 40, 40, 150));
  Base(kNow - 10'000);
  Ptu(kNow - 10'000);
  EXPECT_FALSE(eyes_.LookHead(history_).has_value());
  Base(kNow + 100'000);
  Ptu(kNow + 100'000);
  const auto sighting = eyes_.LookHead(history_);
  ASSERT_TRUE(sighting.has_value());
  EXPECT_TRUE(sighting->still);
  ASSERT_TRUE(sighting->seen.target.has_value());
  EXPECT_TRUE(sighting->seen.touched.left && sighting->seen.touched.bottom);
  EXPECT_FALSE(eyes_.LookHead(history_).has_value());
}

TEST_F(EyesTest, TheHeadMustStandThroughTheExposureThatThePictureStates) {
  sensor::Image picture = Plain(160, 120, 40, 40, 150);
  picture.exposure_s = 0.150;
  eyes_.TakeHead(picture);
  Base(kNow - 10'000);
  Ptu(kNow - 10'000);
  Base(kNow + 100'000);
  Ptu(kNow + 100'000);
  EXPECT_FALSE(eyes_.LookHead(history_).has_value());
  Ptu(kNow + 200'000);
  EXPECT_TRUE(eyes_.LookHead(history_).has_value());
}

TEST_F(EyesTest, LearnsTheFloorFromTheFirstGoodPicture) {
  Base(kNow);
  eyes_.TakeFloor(Plain(160, 120, 60, 60, 60));  // something dark stands there
  const auto dark = eyes_.LookFloor(history_, navigation::RingEchoes());
  ASSERT_TRUE(dark.has_value());
  EXPECT_FALSE(eyes_.floor_learned());
  EXPECT_TRUE(dark->columns.front().obstacle);
  eyes_.TakeFloor(Plain(160, 120, 112, 120, 120));
  const auto floor = eyes_.LookFloor(history_, navigation::RingEchoes());
  ASSERT_TRUE(floor.has_value());
  EXPECT_TRUE(eyes_.floor_learned());
  EXPECT_FALSE(floor->columns.front().obstacle);
}

TEST_F(EyesTest, ASecondLightThatIsDoubtedIsForgottenForGood) {
  Base(kNow);
  const auto shows_obstacles = [&](const sensor::Image& picture) {
    eyes_.TakeFloor(picture);
    return eyes_.LookFloor(history_, navigation::RingEchoes())->columns.front().obstacle;
  };
  const sensor::Image shade = Plain(160, 120, 124, 133, 133), sun = Plain(160, 120, 250, 240, 228);
  EXPECT_FALSE(shows_obstacles(shade));
  EXPECT_FALSE(shows_obstacles(sun));
  EXPECT_FALSE(eyes_.learns_floor());
  eyes_.DoubtOtherLight();
  EXPECT_FALSE(eyes_.learns_floor());
  EXPECT_TRUE(shows_obstacles(sun));
  EXPECT_FALSE(shows_obstacles(shade));
}

TEST_F(EyesTest, ColoursAreReadInTheOrderThePictureSays) {
  Base(kNow);
  sensor::Image rgb = Plain(160, 120, 150, 150, 140);  // as kRgb8: the floor's own colour
  rgb.format = sensor::PixelFormat::kRgb8;
  eyes_.TakeFloor(rgb);
  EXPECT_FALSE(eyes_.LookFloor(history_, navigation::RingEchoes())->columns.front().obstacle);
  EXPECT_TRUE(eyes_.floor_learned());
}

TEST_F(EyesTest, AGreyPictureIsABrokenContract) {
  Base(kNow);
  sensor::Image gray = Plain(160, 120, 0, 0, 0);
  gray.format = sensor::PixelFormat::kGray8;
  eyes_.TakeFloor(gray);
  EXPECT_THROW(eyes_.LookFloor(history_, navigation::RingEchoes()), ContractViolation);
}

TEST_F(EyesTest, WhatIsDoneWithIsNotSeenAgain) {
  const sensor::Image two = RedSquares({{left_px_, 12}, {right_px_, 8}});
  ASSERT_TRUE(HeadSees(two).has_value());
  EXPECT_LT((*HeadSees(two) - left_px_).norm(), 2.0) << "the larger";
  Focus focus;
  focus.ignored_W_m = {Place(left_px_, 2.0)};
  eyes_.SetFocus(focus);
  ASSERT_TRUE(HeadSees(two).has_value());
  EXPECT_LT((*HeadSees(two) - right_px_).norm(), 2.0);
  focus.ignored_W_m.push_back(Place(right_px_, 3.0));
  eyes_.SetFocus(focus);
  EXPECT_FALSE(HeadSees(two).has_value());
  eyes_.SetFocus({});
  EXPECT_TRUE(HeadSees(two).has_value());
}

TEST_F(EyesTest, AnIgnoredPlaceHidesNothingBesideItNorBehindTheCamera) {
  const sensor::Image one = RedSquares({{right_px_, 10}});
  Focus focus;
  focus.ignored_W_m = {Place(left_px_, 3.0)};  // 0.6 m beside
  eyes_.SetFocus(focus);
  EXPECT_TRUE(HeadSees(one).has_value());
  focus.ignored_W_m = {Place(right_px_, -2.0)};
  eyes_.SetFocus(focus);
  EXPECT_TRUE(HeadSees(one).has_value());
}

TEST_F(EyesTest, WhatIsExpectedIsPreferredToWhatIsLargerAndElseTheLargestIsSeen) {
  const sensor::Image two = RedSquares({{left_px_, 12}, {right_px_, 8}});
  Focus focus;
  focus.expected_W_m = {Place(right_px_, 4.0)};
  eyes_.SetFocus(focus);
  ASSERT_TRUE(HeadSees(two).has_value());
  EXPECT_LT((*HeadSees(two) - right_px_).norm(), 2.0);
  ASSERT_TRUE(HeadSees(RedSquares({{left_px_, 12}})).has_value()) << "it was expected wrongly";
  focus.ignored_W_m = focus.expected_W_m;
  eyes_.SetFocus(focus);
  EXPECT_LT((*HeadSees(two) - left_px_).norm(), 2.0) << "done with counts more";
}

TEST_F(EyesTest, WhatSomebodyElseHasSeenIsIgnoredToo) {
  attention::TargetSighting seen;
  seen.width_px = kWide_px;
  seen.height_px = kHigh_px;
  attention::Blob blob;
  blob.center_px = left_px_;
  blob.pixels = 100;
  seen.target = blob;
  sensor::Image picture;
  picture.utime = kNow;
  ASSERT_TRUE(HeadSees(picture, seen).has_value());
  Focus focus;
  focus.ignored_W_m = {Place(left_px_, 2.0)};
  eyes_.SetFocus(focus);
  EXPECT_FALSE(HeadSees(picture, seen).has_value());
  focus.ignored_W_m = {Place(right_px_, 4.0)};
  eyes_.SetFocus(focus);
  EXPECT_TRUE(HeadSees(picture, seen).has_value());
}

TEST_F(EyesTest, TheFloorCameraIgnoresTheSamePlaces) {
  const geometry::SensorRig rig = SmallRig();
  const Eigen::Vector3d place_W_m = rig.X_RF * (1.2 * rig.floor_camera.Ray(79.5, 59.5));
  const sensor::Image one = RedSquares({{Eigen::Vector2d(79.5, 59.5), 10}});
  const auto floor_sees = [&] {
    Base(kNow);
    eyes_.TakeFloor(one);
    const auto sighting = eyes_.LookFloor(history_, std::nullopt);
    EXPECT_TRUE(sighting.has_value());
    return sighting && sighting->seen.target.has_value();
  };
  EXPECT_TRUE(floor_sees());
  Focus focus;
  focus.ignored_W_m = {place_W_m};
  eyes_.SetFocus(focus);
  EXPECT_FALSE(floor_sees());
}

}  // namespace
}  // namespace geon::mission
