#include "procs/geon/picture_uri.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::cli {
namespace {

using testing::StartsWith;

sensor::Image Grey(int width_px, int height_px) {
  sensor::Image image;
  image.width_px = width_px;
  image.height_px = height_px;
  image.row_stride_bytes = 3 * width_px;
  image.format = sensor::PixelFormat::kBgr8;
  image.data.assign(static_cast<size_t>(3 * width_px * height_px), 90);
  return image;
}

TEST(PictureUriTest, APictureIsAJpegAndNoneIsNothing) {
  EXPECT_THAT(PictureUri(Grey(40, 30)), StartsWith("data:image/jpeg;base64,/9j/"));
  EXPECT_EQ(PictureUri(sensor::Image()), "");
}

TEST(PictureUriTest, TheMaskIsOutlined) {
  const sensor::Image picture = Grey(40, 30);
  std::vector<uint8_t> mask(40 * 30, 0);
  EXPECT_EQ(PictureUri(picture, mask), PictureUri(picture));
  for (size_t k = 10; k < 20; ++k)
    std::fill_n(mask.begin() + 40 * static_cast<int>(k) + 10, 20, 255);
  EXPECT_NE(PictureUri(picture, mask), PictureUri(picture));
}

TEST(PictureUriTest, ASmallerOneHasFewerBytesAndItIsNeverEnlarged) {
  const sensor::Image picture = Grey(320, 240);
  EXPECT_LT(PictureUri(picture, {}, 80).size(), PictureUri(picture).size());
  EXPECT_EQ(PictureUri(picture, {}, 640), PictureUri(picture));
}

}  // namespace
}  // namespace geon::cli
