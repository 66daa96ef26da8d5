#include "procs/geon/heat_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::cli {
namespace {

using testing::HasSubstr;

TEST(HeatGrid, OnlyNothingIsWhite) {
  EXPECT_EQ(HeatClass(HeatHue::kRight, 0.0), "b0");
  EXPECT_EQ(HeatClass(HeatHue::kWrong, 0.001), "o1");
  EXPECT_EQ(HeatClass(HeatHue::kWrong, 0.125), "o1");
  EXPECT_EQ(HeatClass(HeatHue::kWrong, 0.126), "o2");
  EXPECT_EQ(HeatClass(HeatHue::kRight, 1.0), "b8");
  EXPECT_EQ(HeatClass(HeatHue::kRight, 7.0), "b8");
}

TEST(HeatGrid, CountsRowsFromTheTop) {
  HeatGrid grid(2, 2, {.cell_width_px = 10, .cell_height_px = 20, .left_px = 30, .top_px = 40});
  grid.Cell(0, 1, HeatHue::kRight, 1.0, "a <cell>");
  EXPECT_THAT(grid.Svg("grid"),
              testing::AllOf(HasSubstr("x=\"40.0\" y=\"40.0\" width=\"10.0\" height=\"20.0\""),
                             HasSubstr("<title>a &lt;cell&gt;</title>"),
                             HasSubstr("viewBox=\"0 0 50.0 80.0\"")));
}

TEST(HeatGrid, TextIsLightOnDarkCells) {
  HeatGrid grid(1, 1, {});
  grid.CellText(0, 0, {0, 0}, "middle", "cell", 0.1, "10");
  EXPECT_THAT(grid.Svg(""), HasSubstr("class=\"cell\""));
  grid.CellText(0, 0, {0, 0}, "middle", "cell", 1.0, "100");
  EXPECT_THAT(grid.Svg(""), HasSubstr("class=\"cell on\""));
}

}  // namespace
}  // namespace geon::cli
