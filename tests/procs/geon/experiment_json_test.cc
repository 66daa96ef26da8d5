#include "procs/geon/experiment_json.h"

#include <gtest/gtest.h>

namespace geon::cli {
namespace {

TEST(ExperimentJsonTest, NothingIsNullAndComesBackAsNothing) {
  EXPECT_TRUE(OptionalJson(std::nullopt).is_null());
  EXPECT_FALSE(ParseOptional(OptionalJson(std::nullopt)).has_value());
  EXPECT_EQ(ParseOptional(OptionalJson(0.25)), 0.25);
  EXPECT_TRUE(LabelJson(std::nullopt).is_null());
  EXPECT_FALSE(ParseOptionalLabel(LabelJson(std::nullopt)).has_value());
  EXPECT_EQ(ParseOptionalLabel(LabelJson(GeonLabel::kBentCuboid)), GeonLabel::kBentCuboid);
  EXPECT_THROW(ParseLabel("cube"), std::bad_optional_access);
}

TEST(ExperimentJsonTest, ACellForEachSubjectAtEachRangeCountsWhatWasNotAnsweredToo) {
  const evaluation::Subject lying{GeonLabel::kCylinder, "floor", 2};
  const evaluation::Subject upright{GeonLabel::kCylinder, "floor", 1};
  const auto cells = AnswerCells({{lying, std::nullopt, GeonLabel::kCylinder, true},
                                  {upright, std::nullopt, GeonLabel::kCuboid, false},
                                  {lying, std::nullopt, std::nullopt, false},
                                  {lying, 1.3, GeonLabel::kCylinder, true}});
  ASSERT_EQ(cells.size(), 3U);
  EXPECT_EQ(cells[0].at("truth"), "cylinder");
  EXPECT_EQ(cells[0].at("object"), "floor");
  EXPECT_EQ(cells[0].at("position"), 2);
  EXPECT_TRUE(cells[0].at("range_m").is_null());
  EXPECT_EQ(cells[0].at("n"), 2);
  EXPECT_EQ(cells[0].at("counts").at("cylinder"), 1);
  EXPECT_EQ(cells[0].at("counts").size(), kGeonLabelNames.size());
  EXPECT_EQ(cells[0].at("undecided"), 1);
  EXPECT_EQ(cells[1].at("position"), 1);
  EXPECT_EQ(cells[1].at("undecided"), 1);
  EXPECT_EQ(cells[2].at("range_m"), 1.3);
}

}  // namespace
}  // namespace geon::cli
