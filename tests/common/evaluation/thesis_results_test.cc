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

TEST(ThesisResults, KnowsNoOtherObjects) {
  EXPECT_FALSE(ThesisRow({GeonLabel::kCuboid, "banana", 1}).has_value());
  EXPECT_FALSE(ThesisRow({GeonLabel::kBentCylinder, "2", 2}).has_value());  // N/A in table 6.4
}

}  // namespace
}  // namespace geon::evaluation
