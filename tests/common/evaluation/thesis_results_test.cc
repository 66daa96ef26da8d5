#include "evaluation/thesis_results.h"

#include <gtest/gtest.h>

#include <numeric>

#include "evaluation/thesis_objects.h"

namespace geon::evaluation {
namespace {

TEST(ThesisResults, EveryRowIsAHundredPercentWithinRounding) {
  for (const ExperimentObject& object : ThesisObjects()) {
    for (int position : object.positions) {
      const auto row = ThesisRow({object.shape.label, object.name, position});
      ASSERT_TRUE(row.has_value());
      EXPECT_NEAR(std::accumulate(row->begin(), row->end(), 0), 100, 2);
    }
  }
}

TEST(ThesisResults, ColumnsAreInTheThesissOrder) {
  // Table 6.4, object 1, position 1: 27 % bent cuboid, 73 % bent cylinder.
  const auto row = ThesisRow({GeonLabel::kBentCylinder, "1", 1});
  ASSERT_TRUE(row.has_value());
  EXPECT_EQ(*row, (std::array{0, 0, 27, 73, 0, 0, 0}));
}

TEST(ThesisResults, MeanRowsAreInTheOrderOfLabels) {
  const std::vector<Subject> two = {{GeonLabel::kBentCylinder, "1", 1},
                                    {GeonLabel::kBentCylinder, "2", 1}};
  const auto mean = ThesisMeanRow(two);
  ASSERT_TRUE(mean.has_value());
  EXPECT_NEAR((*mean)[static_cast<size_t>(GeonLabel::kBentCuboid)], 33.5, 1e-9);
  EXPECT_NEAR((*mean)[static_cast<size_t>(GeonLabel::kBentCylinder)], 66.5, 1e-9);
  EXPECT_FALSE(ThesisMeanRow({}).has_value());
  EXPECT_FALSE(ThesisMeanRow(std::vector<Subject>{two[0], {GeonLabel::kCuboid, "banana", 1}}));
}

TEST(ThesisResults, KnowsNoOtherObjects) {
  EXPECT_FALSE(ThesisRow({GeonLabel::kCuboid, "banana", 1}).has_value());
  EXPECT_FALSE(ThesisRow({GeonLabel::kBentCylinder, "2", 2}).has_value());  // N/A in table 6.4
}

TEST(ThesisResults, RunsAreThoseThatItGivesInPercent) {
  EXPECT_NEAR(kThesisRunsOnFloor.value_1(), 0.47, 0.005);
  EXPECT_NEAR(kThesisRunsOnBox.value_1(), 0.73, 0.005);
  EXPECT_NEAR(kThesisRuns.value_1(), 0.60, 0.005);
  EXPECT_EQ(kThesisRunsOnFloor.n + kThesisRunsOnBox.n, kThesisRuns.n);
  EXPECT_EQ(kThesisRunsOnFloor.right + kThesisRunsOnBox.right, kThesisRuns.right);
}

}  // namespace
}  // namespace geon::evaluation
