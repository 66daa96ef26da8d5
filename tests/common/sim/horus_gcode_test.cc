#include "sim/horus_gcode.h"

#include <gtest/gtest.h>

namespace geon::sim {
namespace {

std::string Verdict(const char* line, bool modal = false) {
  HorusBlock block;
  return ParseHorusBlock(line, modal, &block);
}

TEST(HorusGcode, ReadsWordsInAnyOrder) {
  HorusBlock block;
  EXPECT_EQ(ParseHorusBlock("M71T2", false, &block), "ok");
  EXPECT_EQ(block.m_code, 71);
  EXPECT_EQ(block.tool, 2);
  EXPECT_FALSE(block.moves);
  EXPECT_EQ(ParseHorusBlock("G1X-12.5F200", false, &block), "ok");
  EXPECT_TRUE(block.moves);
  EXPECT_DOUBLE_EQ(*block.x_deg, -12.5);
  EXPECT_DOUBLE_EQ(*block.feed_deg_s, 200.0);
  EXPECT_EQ(ParseHorusBlock("G50", false, &block), "ok");
  EXPECT_TRUE(block.sets_zero);
}

TEST(HorusGcode, EachKindOfNonsenseHasItsText) {
  EXPECT_EQ(Verdict("71"), "Expected command letter");
  EXPECT_EQ(Verdict("#"), "Expected command letter");
  EXPECT_EQ(Verdict("M"), "Bad number format");
  EXPECT_EQ(Verdict("MM71"), "Bad number format");
  EXPECT_EQ(Verdict("M99"), "Unsupported command");
  EXPECT_EQ(Verdict("G0X1"), "Unsupported command");
  EXPECT_EQ(Verdict("S100"), "Unsupported command");
  EXPECT_EQ(Verdict("M999999999999"), "Unsupported command");
  EXPECT_EQ(Verdict("M70.5"), "Invalid gcode ID:23");
  EXPECT_EQ(Verdict("M71T1T2"), "Invalid gcode ID:25");
  EXPECT_EQ(Verdict("M71M70T1"), "Modal group violation");
  EXPECT_EQ(Verdict("G1G50"), "Modal group violation");
  EXPECT_EQ(Verdict("M71T-1"), "Value < 0");
  EXPECT_EQ(Verdict("G1F-5"), "Value < 0");
  EXPECT_EQ(Verdict("X5"), "Invalid statement");
  EXPECT_EQ(Verdict("X5", true), "ok") << "under a G1 before it";
}

}  // namespace
}  // namespace geon::sim
