#include "mission/eyes.h"

#include <gtest/gtest.h>

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
  const auto dark = eyes_.LookFloor(history_, true);
  ASSERT_TRUE(dark.has_value());
  EXPECT_FALSE(eyes_.floor_learned());
  EXPECT_TRUE(dark->columns.front().obstacle);
  eyes_.TakeFloor(Plain(160, 120, 112, 120, 120));
  const auto floor = eyes_.LookFloor(history_, true);
  ASSERT_TRUE(floor.has_value());
  EXPECT_TRUE(eyes_.floor_learned());
  EXPECT_FALSE(floor->columns.front().obstacle);
}

TEST_F(EyesTest, ColoursAreReadInTheOrderThePictureSays) {
  Base(kNow);
  sensor::Image rgb = Plain(160, 120, 150, 150, 140);  // as kRgb8: the floor's own colour
  rgb.format = sensor::PixelFormat::kRgb8;
  eyes_.TakeFloor(rgb);
  EXPECT_FALSE(eyes_.LookFloor(history_, true)->columns.front().obstacle);
  EXPECT_TRUE(eyes_.floor_learned());
}

TEST_F(EyesTest, AGreyPictureIsABrokenContract) {
  Base(kNow);
  sensor::Image gray = Plain(160, 120, 0, 0, 0);
  gray.format = sensor::PixelFormat::kGray8;
  eyes_.TakeFloor(gray);
  EXPECT_THROW(eyes_.LookFloor(history_, true), ContractViolation);
}

}  // namespace
}  // namespace geon::mission
