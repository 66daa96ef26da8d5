#include "device/frame_message.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace geon::device {
namespace {

const std::string kGood =
    R"({"seq":7,"utime":1700000000000001,"width":3,"height":2,"format":"bgr8","exposure_us":8000})";

Result<sensor::Image> Parse(const std::string& header, size_t bytes = 18) {
  return ParseFrame(header, std::vector<uint8_t>(bytes, 5));
}

std::string With(const std::string& from, const std::string& to) {
  std::string header = kGood;
  header.replace(header.find(from), from.size(), to);
  return header;
}

TEST(FrameMessage, AGoodFrameBecomesAnImage) {
  const auto image = Parse(kGood);
  ASSERT_TRUE(image.ok()) << image.message();
  EXPECT_EQ(image->seq, 7);
  EXPECT_EQ(image->utime, 1700000000000001);
  EXPECT_EQ(image->width_px, 3);
  EXPECT_EQ(image->height_px, 2);
  EXPECT_EQ(image->row_stride_bytes, 9);
  EXPECT_EQ(image->format, sensor::PixelFormat::kBgr8);
  EXPECT_EQ(image->data.size(), 18u);
  EXPECT_DOUBLE_EQ(image->exposure_s.value(), 0.008);
  EXPECT_EQ(Parse(With("bgr8", "gray8"), 6)->format, sensor::PixelFormat::kGray8);
}

TEST(FrameMessage, PixelsMustBeWhatTheHeaderSays) {
  EXPECT_FALSE(Parse(kGood, 17).ok());
  EXPECT_FALSE(Parse(kGood, 19).ok());
  EXPECT_FALSE(Parse(kGood, 0).ok());
}

TEST(FrameMessage, BadHeadersAreRefused) {
  for (const std::string& header :
       {std::string(), std::string("{"), std::string("[1]"), std::string("null"),
        With("\"seq\":7", "\"seq\":-1"), With("\"seq\":7", "\"seq\":7.5"),
        With("\"seq\":7", "\"seq\":99999999999"), With("\"width\":3", "\"width\":0"),
        With("\"width\":3", "\"width\":9000000000000000000"),
        With("\"utime\":1700000000000001", "\"utime\":18446744073709551615"),
        With("\"height\":2", "\"height\":\"2\""), With("bgr8", "rgb16"),
        With("\"exposure_us\":8000", "\"exposure_us\":-5"), With("\"width\"", "\"breadth\"")}) {
    const auto image = Parse(header);
    EXPECT_FALSE(image.ok()) << header;
    EXPECT_FALSE(image.message().empty());
  }
}

}  // namespace
}  // namespace geon::device
