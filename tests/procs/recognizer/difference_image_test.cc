#include "procs/recognizer/difference_image.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace geon::recognizer {
namespace {

cv::Mat Ramp() {
  cv::Mat pixels(4, 8, CV_8UC1);
  for (int v = 0; v < 4; ++v) {
    for (int u = 0; u < 8; ++u) pixels.at<uint8_t>(v, u) = static_cast<uint8_t>(10 * v + u);
  }
  return pixels;
}

sensor::Image Png(const cv::Mat& pixels) {
  sensor::Image image;
  image.format = sensor::PixelFormat::kPng;
  cv::imencode(".png", pixels, image.data);
  return image;
}

sensor::Image Gray(const cv::Mat& pixels) {
  sensor::Image image;
  image.format = sensor::PixelFormat::kGray8;
  image.width_px = pixels.cols;
  image.height_px = pixels.rows;
  image.row_stride_bytes = pixels.cols;
  image.data.assign(pixels.datastart, pixels.dataend);
  return image;
}

TEST(DifferenceImage, PngAndGreyLevelsGiveTheSamePixels) {
  const auto from_png = DifferenceImage(Png(Ramp()), 8, 4);
  const auto from_gray = DifferenceImage(Gray(Ramp()), 8, 4);
  ASSERT_TRUE(from_png.ok() && from_gray.ok());
  EXPECT_EQ(from_png->data, from_gray->data);
  EXPECT_EQ(from_png->row_stride_bytes, 8);
}

TEST(DifferenceImage, RefusesOtherSizes) {
  EXPECT_FALSE(DifferenceImage(Png(Ramp()), 4, 8).ok());
  EXPECT_FALSE(DifferenceImage(Gray(Ramp()), 8, 5).ok());
}

TEST(DifferenceImage, RefusesTornData) {
  sensor::Image torn = Gray(Ramp());
  torn.data.resize(20);
  EXPECT_FALSE(DifferenceImage(torn, 8, 4).ok());
  sensor::Image png = Png(Ramp());
  png.data.resize(30);
  EXPECT_FALSE(DifferenceImage(png, 8, 4).ok());
  png.data.resize(10);
  EXPECT_FALSE(DifferenceImage(png, 8, 4).ok());
}

TEST(DifferenceImage, RefusesColour) {
  sensor::Image color = Gray(Ramp());
  color.format = sensor::PixelFormat::kBgr8;
  EXPECT_FALSE(DifferenceImage(color, 8, 4).ok());
}

}  // namespace
}  // namespace geon::recognizer
