#include "rangefinder/laser_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "base/contracts.h"

namespace geon::rangefinder {
namespace {

using sensor::PixelFormat;
using Color = std::array<uint8_t, 3>;  // red, green, blue

sensor::Image Filled(PixelFormat format, const Color& color, int width_px = 120,
                     int height_px = 90) {
  sensor::Image image;
  image.width_px = width_px;
  image.height_px = height_px;
  image.format = format;
  const int channels = sensor::ChannelCount(format);
  image.row_stride_bytes = channels * width_px;
  for (int i = 0; i < width_px * height_px; ++i) {
    if (channels == 1) image.data.push_back(color[0]);
    for (int c = 0; c < 3 && channels == 3; ++c) {
      image.data.push_back(color[static_cast<size_t>(format == PixelFormat::kRgb8 ? c : 2 - c)]);
    }
  }
  return image;
}

void PaintColor(sensor::Image* image, const sensor::PixelBox& box, const Color& color) {
  const sensor::Image patch = Filled(image->format, color, box.w_px, box.h_px);
  const int channels = sensor::ChannelCount(image->format);
  for (int v = 0; v < box.h_px; ++v) {
    std::copy_n(
        patch.data.begin() + v * patch.row_stride_bytes, box.w_px * channels,
        image->data.begin() + (box.v_px + v) * image->row_stride_bytes + box.u_px * channels);
  }
}

int LevelAt(const sensor::Image& gray, int u, int v) {
  return gray.data[static_cast<size_t>(v * gray.row_stride_bytes + u)];
}

TEST(LaserLightTest, DifferenceOfLitAndUnlitStopsAtZero) {
  sensor::Image lit = Filled(PixelFormat::kGray8, {50, 0, 0});
  PaintColor(&lit, {10, 10, 20, 2}, {200, 0, 0});
  const auto light = LaserLight(lit, Filled(PixelFormat::kGray8, {60, 0, 0}), LaserColor::kMono);
  EXPECT_EQ(LevelAt(light, 15, 10), 140);
  EXPECT_EQ(LevelAt(light, 15, 20), 0);
  EXPECT_EQ(light.format, PixelFormat::kGray8);
}

TEST(LaserLightTest, DifferenceTakesTheLasersChannel) {
  for (const PixelFormat format : {PixelFormat::kRgb8, PixelFormat::kBgr8}) {
    const auto unlit = Filled(format, {50, 60, 70});
    const auto lit = Filled(format, {150, 80, 70});
    EXPECT_EQ(LevelAt(LaserLight(lit, unlit, LaserColor::kRed), 5, 5), 100);
    EXPECT_EQ(LevelAt(LaserLight(lit, unlit, LaserColor::kGreen), 5, 5), 20);
    EXPECT_EQ(LevelAt(LaserLight(lit, unlit, LaserColor::kMono), 5, 5), 40);
  }
}

TEST(LaserLightTest, SingleFrameKeepsTheStripeAndDropsWhiteThings) {
  sensor::Image lit = Filled(PixelFormat::kBgr8, {110, 105, 90});
  PaintColor(&lit, {60, 0, 30, 90}, {225, 220, 215});  // a white block
  PaintColor(&lit, {0, 40, 60, 3}, {240, 110, 110});   // the stripe on the floor
  PaintColor(&lit, {60, 44, 60, 3}, {255, 160, 160});  // and on the block
  const auto light = LaserLight(lit, LaserColor::kRed);
  EXPECT_GT(LevelAt(light, 30, 41), 80);
  EXPECT_GT(LevelAt(light, 75, 45), 30);
  EXPECT_LT(LevelAt(light, 75, 10), 10);
  EXPECT_LT(LevelAt(light, 59, 10), 20) << "the block's edge";
  EXPECT_LT(LevelAt(light, 10, 10), 10);
}

TEST(LaserLightTest, SaturatedWhiteCoreOfTheStripeStaysItsBrightest) {
  sensor::Image lit = Filled(PixelFormat::kBgr8, {12, 10, 10});
  PaintColor(&lit, {0, 40, 120, 7}, {180, 10, 40});
  PaintColor(&lit, {0, 42, 120, 3}, {255, 255, 255});
  const auto light = LaserLight(lit, LaserColor::kRed);
  EXPECT_GT(LevelAt(light, 60, 43), LevelAt(light, 60, 40));
  EXPECT_GT(LevelAt(light, 60, 43), 200);
}

TEST(LaserLightTest, MonoFrameLosesItsSlowBackground) {
  sensor::Image lit = Filled(PixelFormat::kGray8, {80, 0, 0});
  PaintColor(&lit, {0, 0, 60, 90}, {120, 0, 0});
  PaintColor(&lit, {0, 44, 120, 3}, {220, 0, 0});
  const auto light = LaserLight(lit, LaserColor::kMono);
  EXPECT_EQ(LevelAt(light, 20, 45), 100);
  EXPECT_EQ(LevelAt(light, 100, 45), 140);
  EXPECT_EQ(LevelAt(light, 20, 10), 0);
  EXPECT_EQ(LevelAt(light, 100, 10), 0);
}

TEST(LaserLightTest, AverageIsTheRoundedMean) {
  const auto average = AverageImages({Filled(PixelFormat::kGray8, {10, 0, 0}),
                                      Filled(PixelFormat::kGray8, {11, 0, 0}),
                                      Filled(PixelFormat::kGray8, {14, 0, 0})});
  EXPECT_EQ(LevelAt(average, 3, 3), 12);
}

TEST(LaserLightTest, BrokenContractsThrow) {
  const auto gray = Filled(PixelFormat::kGray8, {10, 0, 0});
  const auto small = Filled(PixelFormat::kGray8, {10, 0, 0}, 20, 20);
  EXPECT_THROW(LaserLight(gray, small, LaserColor::kMono), ContractViolation);
  EXPECT_THROW(AverageImages({}), ContractViolation);
  EXPECT_THROW(AverageImages({gray, small}), ContractViolation);
  sensor::Image compressed = gray;
  compressed.format = PixelFormat::kPng;
  EXPECT_THROW(LaserLight(compressed, LaserColor::kMono), ContractViolation);
}

}  // namespace
}  // namespace geon::rangefinder
