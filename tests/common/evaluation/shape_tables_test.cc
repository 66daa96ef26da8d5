#include "evaluation/shape_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::evaluation {
namespace {

using testing::HasSubstr;
using testing::Not;

// All answers given with 80 % confidence, the wrong ones undecided.
Reliability Trust(const ConfusionRow& row) {
  std::vector<Prediction> predictions;
  for (int k = 0; k < row.n(); ++k) {
    const bool right = k < row.rate().right;
    predictions.push_back({0.8, right, right});
  }
  return MeasureReliability(predictions);
}

TEST(ShapeTables, StandBesideTheThesissFigures) {
  ConfusionRow row{{GeonLabel::kBentCylinder, "1", 1}, {}, 2};
  row.counts[static_cast<size_t>(GeonLabel::kBentCylinder)] = 9;
  row.counts[static_cast<size_t>(GeonLabel::kBentCuboid)] = 3;
  const std::vector<CellRate> cells = {{{0.6, 0.0}, {4, 4}}, {{0.6, 0.2}, {5, 8}}};
  const std::string text = ShapeTables(std::vector{row}, cells, Trust(row));
  EXPECT_THAT(text, HasSubstr("Table 6.4"));
  EXPECT_THAT(text, Not(HasSubstr("Table 6.1")));
  EXPECT_THAT(text, HasSubstr("25 (27)    75 (73)"));
  EXPECT_THAT(text, HasSubstr("mean of rows  75.0 (73.0)"));
  EXPECT_THAT(text, HasSubstr("75.0 % of 12 (95 %: 46.8-91.1)"));
  EXPECT_THAT(text, HasSubstr("undecided: 2"));
  EXPECT_THAT(text, HasSubstr("34 deg   25.0 % of 12"));
  EXPECT_THAT(text, HasSubstr("0 to 38 % error (3 to 30)"));
}

TEST(ShapeTables, NameTheWorstAndHowFarTheConfidenceIsToBeBelieved) {
  ConfusionRow good{{GeonLabel::kCuboid, "2", 1}, {}, 0};
  good.counts[static_cast<size_t>(GeonLabel::kCuboid)] = 12;
  ConfusionRow bad{{GeonLabel::kBentCylinder, "3", 2}, {}, 3};
  bad.counts[static_cast<size_t>(GeonLabel::kBentCylinder)] = 9;
  bad.counts[static_cast<size_t>(GeonLabel::kBentCuboid)] = 3;
  const std::vector<CellRate> cells = {{{0.6, 0.0}, {16, 16}}, {{0.6, 0.5}, {5, 8}}};
  const std::string text = ShapeTables(std::vector{good, bad}, cells, Trust(bad));
  EXPECT_THAT(text, HasSubstr("worst class: bent_cylinder, right  75.0 % of 12"));
  EXPECT_THAT(text, HasSubstr("worst row: bent_cylinder, object 3, position 2, right  75.0 %"));
  EXPECT_THAT(text, HasSubstr("worst view: elevation 34 deg, azimuth 29 deg, right  62.5 % of 8"));
  EXPECT_THAT(text, HasSubstr("decided:  75.0 % of 12"));
  EXPECT_THAT(text, HasSubstr("right among the decided: 100.0 % of 9"));
  EXPECT_THAT(text, HasSubstr("expected calibration error: 5.00 %"));
}

TEST(ShapeTables, ObjectsTheThesisDidNotHaveStandAlone) {
  ConfusionRow row{{GeonLabel::kBentCylinder, "banana", 1}, {}, 0};
  row.counts[static_cast<size_t>(GeonLabel::kBentCylinder)] = 1;
  const std::string text =
      ShapeTables(std::vector{row}, std::vector<CellRate>{{{0.6, 0.0}, {1, 1}}}, Trust(row));
  EXPECT_THAT(text, Not(HasSubstr("(100)")));
  EXPECT_THAT(text, HasSubstr("banana"));
}

TEST(ShapeTables, NoTrialsAreSaidToBeNone) { EXPECT_EQ(ShapeTables({}, {}, {}), "No trials.\n"); }

}  // namespace
}  // namespace geon::evaluation
