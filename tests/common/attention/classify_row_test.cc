#include "attention/classify_row.h"

#include <gtest/gtest.h>

namespace geon::attention {
namespace {

// Two words of pixels; what the other levels and colours do is tested in classify_pixels_test.cc.
TEST(ClassifyRowTest, PixelsAreBitsFromTheLowestOnAndDoubtIsTold) {
  std::vector<uint8_t> row(3 * 128, 60);
  row[3 * 0] = 150;   // red 150, green and blue 60
  row[3 * 65] = 100;  // red 100: in between
  row[3 * 127 + 1] = 255;
  RegionTest region;
  region.planes = {{{1, 0, 0}, 120, 90}};
  region.doubtful = true;
  const RowTests tests = {&region, 1, nullptr, 0, 0, 255, 250};
  uint64_t target[2], rim[2] = {0, 0}, cannot_tell[2], lost[2], doubt[2];
  ClassifyRowBaseline(row.data(), true, 2, tests, {target, rim, cannot_tell, lost, doubt});
  EXPECT_EQ(target[0], 1U);
  EXPECT_EQ(target[1], 0U);
  EXPECT_EQ(doubt[0], 0U);
  EXPECT_EQ(doubt[1], 2U);
  EXPECT_EQ(rim[0] | rim[1], 0U);
  EXPECT_EQ(cannot_tell[1], uint64_t{1} << 63);
  EXPECT_EQ(lost[1], uint64_t{1} << 63);
}

}  // namespace
}  // namespace geon::attention
