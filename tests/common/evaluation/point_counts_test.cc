#include "evaluation/point_counts.h"

#include <gtest/gtest.h>

namespace geon::evaluation {
namespace {

TEST(PointCounts, CountsEachKind) {
  PointCounts counts;
  counts.Count({true, true, true, false, false}, {true, true, false, true, false});
  EXPECT_EQ(counts.kept, 2);
  EXPECT_EQ(counts.lost, 1);
  EXPECT_EQ(counts.strays, 1);
  EXPECT_DOUBLE_EQ(counts.f1_1(), 4.0 / 6.0);
  EXPECT_DOUBLE_EQ(counts.lost_1(), 1.0 / 3.0);
  counts += counts;
  EXPECT_EQ(counts.kept, 4);
}

TEST(PointCounts, NothingToFindIsFound) { EXPECT_EQ(PointCounts{}.f1_1(), 1.0); }

}  // namespace
}  // namespace geon::evaluation
