#include "evaluation/success_rate.h"

#include <gtest/gtest.h>

namespace geon::evaluation {
namespace {

TEST(WilsonInterval, IsThatOfThePublishedExample) {
  // 81 of 263: 0.2553 to 0.3662 (Newcombe 1998, table I, method 3).
  const Interval interval = WilsonInterval({81, 263});
  EXPECT_NEAR(interval.low_1, 0.2553, 5e-5);
  EXPECT_NEAR(interval.high_1, 0.3662, 5e-5);
}

TEST(WilsonInterval, MeansSomethingAtTheEnds) {
  EXPECT_EQ(WilsonInterval({0, 20}).low_1, 0.0);
  EXPECT_NEAR(WilsonInterval({0, 20}).high_1, 0.1611, 5e-5);
  EXPECT_NEAR(WilsonInterval({20, 20}).low_1, 1.0 - 0.1611, 5e-5);
  EXPECT_EQ(WilsonInterval({0, 0}).high_1, 1.0);
}

TEST(SuccessRate, Counts) {
  SuccessRate rate;
  rate.Count(true);
  rate.Count(false);
  EXPECT_EQ(rate.value_1(), 0.5);
  EXPECT_EQ(SuccessRate().value_1(), 0.0);
}

}  // namespace
}  // namespace geon::evaluation
