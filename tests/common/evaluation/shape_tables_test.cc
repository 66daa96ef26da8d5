#include "evaluation/shape_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::evaluation {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ShapeTables, StandBesideTheThesissFigures) {
  ConfusionRow row{{GeonLabel::kBentCylinder, "1", 1}, {}, 2};
  row.counts[static_cast<size_t>(GeonLabel::kBentCylinder)] = 9;
  row.counts[static_cast<size_t>(GeonLabel::kBentCuboid)] = 3;
  const std::vector<CellRate> cells = {{{0.6, 0.0}, {4, 4}}, {{0.6, 0.2}, {5, 8}}};
  const std::string text = ShapeTables(std::vector{row}, cells);
  EXPECT_THAT(text, HasSubstr("Table 6.4"));
  EXPECT_THAT(text, Not(HasSubstr("Table 6.1")));
  EXPECT_THAT(text, HasSubstr("25 (27)    75 (73)"));
  EXPECT_THAT(text, HasSubstr("mean of rows  75.0 (73.0)"));
  EXPECT_THAT(text, HasSubstr("75.0 % of 12 (95 %: 46.8-91.1)"));
  EXPECT_THAT(text, HasSubstr("undecided: 2"));
  EXPECT_THAT(text, HasSubstr("34 deg   25.0 % of 12"));
  EXPECT_THAT(text, HasSubstr("0 to 38 % error (3 to 30)"));
}

TEST(ShapeTables, ObjectsTheThesisDidNotHaveStandAlone) {
  ConfusionRow row{{GeonLabel::kBentCylinder, "banana", 1}, {}, 0};
  row.counts[static_cast<size_t>(GeonLabel::kBentCylinder)] = 1;
  const std::string text =
      ShapeTables(std::vector{row}, std::vector<CellRate>{{{0.6, 0.0}, {1, 1}}});
  EXPECT_THAT(text, Not(HasSubstr("(100)")));
  EXPECT_THAT(text, HasSubstr("banana"));
}

TEST(ShapeTables, NoTrialsAreSaidToBeNone) { EXPECT_EQ(ShapeTables({}, {}), "No trials.\n"); }

}  // namespace
}  // namespace geon::evaluation
