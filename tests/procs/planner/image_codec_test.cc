#include "procs/planner/image_codec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <opencv2/imgcodecs.hpp>

#include "base/contracts.h"

namespace geon::planner {
namespace {

using testing::HasSubstr;

constexpr int kWidth_px = 32;
constexpr int kHeight_px = 24;

geometry::PinholeCamera Camera() {
  geometry::PinholeCamera camera;
  camera.width_px = kWidth_px;
  camera.height_px = kHeight_px;
  return camera;
}

// A smooth picture, which survives JPEG: blue grows to the right, red downwards.
sensor::Image Picture() {
  sensor::Image image;
  image.utime = 5;
  image.seq = 6;
  image.width_px = kWidth_px;
  image.height_px = kHeight_px;
  image.row_stride_bytes = 3 * kWidth_px;
  image.format = sensor::PixelFormat::kBgr8;
  for (int v = 0; v < kHeight_px; ++v) {
    for (int u = 0; u < kWidth_px; ++u) {
      image.data.push_back(static_cast<uint8_t>(4 * u));
      image.data.push_back(100);
      image.data.push_back(static_cast<uint8_t>(4 * v));
    }
  }
  return image;
}

TEST(ImageCodecTest, RawPicturesPassUntouched) {
  const auto decoded = DecodeColor(Picture(), Camera());
  ASSERT_TRUE(decoded.ok()) << decoded.message();
  EXPECT_EQ(decoded->data, Picture().data);
}

TEST(ImageCodecTest, JpegKeepsTimeNumberAndColours) {
  const auto decoded = DecodeColor(EncodeJpeg(Picture(), 95), Camera());
  ASSERT_TRUE(decoded.ok()) << decoded.message();
  EXPECT_EQ(decoded->utime, 5);
  EXPECT_EQ(decoded->seq, 6);
  ASSERT_EQ(decoded->data.size(), Picture().data.size());
  for (size_t i = 0; i < decoded->data.size(); ++i) {
    EXPECT_NEAR(decoded->data[i], Picture().data[i], 12) << i;
  }
}

TEST(ImageCodecTest, RgbIsEncodedInItsOwnOrder) {
  sensor::Image rgb = Picture();
  rgb.format = sensor::PixelFormat::kRgb8;
  const auto decoded = DecodeColor(EncodeJpeg(rgb, 95), Camera());
  ASSERT_TRUE(decoded.ok());
  EXPECT_NEAR(decoded->data[2], rgb.data[0], 12);
}

TEST(ImageCodecTest, DamagedGreyShortAndForeignPicturesAreErrors) {
  sensor::Image damaged = EncodeJpeg(Picture(), 90);
  damaged.data.resize(10);
  EXPECT_THAT(DecodeColor(damaged, Camera()).message(), HasSubstr("cannot be decoded"));
  damaged.data.clear();
  EXPECT_FALSE(DecodeColor(damaged, Camera()).ok());
  sensor::Image gray = Picture();
  gray.format = sensor::PixelFormat::kGray8;
  EXPECT_THAT(DecodeColor(gray, Camera()).message(), HasSubstr("without colour"));
  sensor::Image cut = Picture();
  cut.data.pop_back();
  EXPECT_THAT(DecodeColor(cut, Camera()).message(), HasSubstr("fewer bytes"));
  geometry::PinholeCamera other = Camera();
  other.width_px = 640;
  EXPECT_THAT(DecodeColor(Picture(), other).message(), HasSubstr("32x24"));
  EXPECT_THROW(EncodeJpeg(gray, 90), ContractViolation);
}

TEST(ImageCodecTest, MasksSurviveBitForBit) {
  std::vector<uint8_t> mask(kWidth_px * kHeight_px, 0);
  for (size_t i = 0; i < mask.size(); i += 3) mask[i] = 255;
  const sensor::Image png = EncodeMask(mask, kWidth_px, kHeight_px);
  const cv::Mat decoded = cv::imdecode(png.data, cv::IMREAD_GRAYSCALE);
  ASSERT_EQ(decoded.total(), mask.size());
  EXPECT_TRUE(std::equal(mask.begin(), mask.end(), decoded.datastart));
}

}  // namespace
}  // namespace geon::planner
