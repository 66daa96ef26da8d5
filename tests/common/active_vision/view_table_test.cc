#include "active_vision/view_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geon::active_vision {
namespace {

TEST(TrainedViewTable, WeighsViewsAndDecidesWithinReason) {
  const FusionOptions& fusion = TrainedViewTable().fusion;
  EXPECT_GT(fusion.weight_1, 0.0);
  EXPECT_LE(fusion.weight_1, 1.2) << "several views never tell much more than independent ones";
  EXPECT_GT(fusion.decided_1, 0.5);
  EXPECT_LT(fusion.decided_1, 1.0) << "nothing would ever be decided";
}

// An undecided look leaves the truth a posterior of a few per cent at least, on the average.
TEST(TrainedViewTable, EveryGainIsFiniteAndNoMoreThanThereIsToGain) {
  for (size_t i = 0; i < kGeonLabelCount; ++i) {
    for (size_t j = 0; j < kGeonLabelCount; ++j) {
      for (const double gain_1 : TrainedViewTable().gain[i][j]) {
        ASSERT_TRUE(std::isfinite(gain_1));
        EXPECT_GT(gain_1, -0.5) << i << ' ' << j;
        EXPECT_LT(gain_1, 3.0) << i << ' ' << j;
      }
    }
  }
}

// A shape's back mostly shows its front again.
TEST(TrainedViewTable, AnotherSideTellsMoreThanTheBack) {
  double side = 0.0, back = 0.0;
  for (const auto& by_second : TrainedViewTable().gain) {
    for (const auto& gain_1 : by_second) {
      side += gain_1[2];
      back += gain_1[5];
    }
  }
  EXPECT_GT(side, back);
}

}  // namespace
}  // namespace geon::active_vision
