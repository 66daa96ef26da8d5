#include "attention/bit_mask.h"

#include <gtest/gtest.h>

#include "base/contracts.h"

namespace geon::attention {
namespace {

TEST(BitMaskTest, RangesAcrossWordsAreSetAndCounted) {
  BitMask mask(200, 3);
  EXPECT_FALSE(mask.Any());
  mask.Set(1, 60, 195);
  EXPECT_TRUE(mask.Any());
  EXPECT_EQ(mask.Count(), 135);
  EXPECT_EQ(mask.Count(1, 0, 200), 135);
  EXPECT_EQ(mask.Count(1, 63, 65), 2);
  EXPECT_EQ(mask.Count(1, 190, 200), 5);
  EXPECT_EQ(mask.Count(0, 0, 200), 0);
  EXPECT_FALSE(mask.At(59, 1));
  EXPECT_TRUE(mask.At(60, 1));
  EXPECT_TRUE(mask.At(194, 1));
  EXPECT_FALSE(mask.At(195, 1));
  EXPECT_EQ(mask.Within(2), ~uint64_t{0});
  EXPECT_EQ(mask.Within(3), uint64_t{0xff});
}

TEST(BitMaskTest, ErosionTakesTheBorderForSet) {
  for (const int width : {1, 64, 65, 130}) {
    BitMask full(width, 5);
    for (int v = 0; v < 5; ++v) full.Set(v, 0, width);
    EXPECT_EQ(Erode(full, 8), full);
    EXPECT_EQ(Erode(full, 4), full);
  }
}

TEST(BitMaskTest, ErosionLooksAtFourOrEightNeighbors) {
  BitMask mask(130, 9);
  for (int v = 0; v < 9; ++v) mask.Set(v, 0, 130);
  mask.row(4)[1] &= ~uint64_t{1};  // a hole at pixel 64
  EXPECT_EQ(Erode(mask, 8).Count(), 130 * 9 - 9);
  EXPECT_EQ(Erode(mask, 4).Count(), 130 * 9 - 5);
  EXPECT_FALSE(Erode(mask, 4).At(63, 4));
  EXPECT_TRUE(Erode(mask, 4).At(63, 3));
  EXPECT_THROW(Erode(mask, 6), ContractViolation);
}

}  // namespace
}  // namespace geon::attention
