#include "attention/pixel_groups.h"

#include <gtest/gtest.h>

namespace geon::attention {
namespace {

BitMask Drawn(const std::vector<std::string>& rows) {
  BitMask mask(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int v = 0; v < mask.height_px(); ++v) {
    for (int u = 0; u < mask.width_px(); ++u) {
      if (rows[static_cast<size_t>(v)][static_cast<size_t>(u)] == '#') mask.Set(v, u, u + 1);
    }
  }
  return mask;
}

TEST(PixelGroupsTest, ArmsThatMeetBelowAreOneGroupAndDiagonalsTouch) {
  const PixelGroups groups = GroupPixels(Drawn({"#.#..#",  //
                                                "#.#.#.",  //
                                                "###...",  //
                                                ".....#"}));
  EXPECT_EQ(groups.count, 3);
  ASSERT_EQ(groups.runs.size(), 8U);
  EXPECT_EQ(groups.runs[0].group, 0);
  EXPECT_EQ(groups.runs[1].group, 0);
  EXPECT_EQ(groups.runs[2].group, 1) << "the third run of the first row";
  EXPECT_EQ(groups.runs[5].group, 1) << "its diagonal neighbour";
  EXPECT_EQ(groups.runs[7].group, 2);
}

TEST(PixelGroupsTest, RunsThatCrossOrFillWordsStayWhole) {
  BitMask mask(256, 3);
  mask.Set(0, 60, 70);
  mask.Set(1, 0, 64);
  mask.Set(1, 128, 256);
  mask.Set(2, 1, 255);
  const PixelGroups groups = GroupPixels(mask);
  EXPECT_EQ(groups.count, 1);
  ASSERT_EQ(groups.runs.size(), 4U);
  EXPECT_EQ(groups.runs[0].u_begin_px, 60);
  EXPECT_EQ(groups.runs[0].u_end_px, 70);
  EXPECT_EQ(groups.runs[1].u_end_px, 64);
  EXPECT_EQ(groups.runs[2].u_begin_px, 128);
  EXPECT_EQ(groups.runs[2].u_end_px, 256);
  EXPECT_EQ(groups.runs[3].v_px, 2);
}

TEST(PixelGroupsTest, EmptyMaskHasNone) { EXPECT_EQ(GroupPixels(BitMask(70, 4)).count, 0); }

}  // namespace
}  // namespace geon::attention
