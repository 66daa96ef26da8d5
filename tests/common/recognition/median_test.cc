#include "recognition/median.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

std::vector<double> Noise(size_t count, bool with_ties) {
  std::mt19937_64 random(count);
  std::normal_distribution<double> gauss;
  std::vector<double> values(count);
  for (double& value : values) {
    value = gauss(random);
    if (with_ties) value = std::round(2.0 * value);
  }
  return values;
}

// The middle of a sorted copy.
double SortedMiddle(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() / 2];
}

TEST(Median, IsTheMiddleOfTheSortedValues) {
  for (bool with_ties : {false, true}) {
    for (size_t count : {1, 2, 3, 15, 16, 17, 18, 100, 101, 640}) {
      const std::vector<double> values = Noise(count, with_ties);
      EXPECT_EQ(Median(values), SortedMiddle(values)) << count << " values, ties " << with_ties;
    }
  }
}

TEST(Median, DoesNotMindValuesInOrderOrAllEqual) {
  std::vector<double> values = Noise(200, false);
  std::sort(values.begin(), values.end());
  EXPECT_EQ(Median(values), values[100]);
  std::reverse(values.begin(), values.end());
  EXPECT_EQ(Median(values), values[99]);
  EXPECT_EQ(Median(std::vector<double>(200, 0.5)), 0.5);
}

TEST(Median, OfNothingIsZero) { EXPECT_EQ(Median({}), 0.0); }

TEST(RunningMedian, IsTheMiddleOfEachWindowWhateverItsWidth) {
  for (int half_width : {0, 1, 2, 3, 4, 5, 6, 7, 8, 12}) {
    for (size_t count : {1, 2, 3, 8, 14, 15, 16, 17, 30, 31, 200}) {
      const std::vector<double> values = Noise(count, count % 2 == 0);
      std::vector<double> medians(count);
      RunningMedian(values, half_width, medians);
      for (size_t i = 0; i < count; ++i) {
        const size_t reach = std::min({static_cast<size_t>(half_width), i, count - 1 - i});
        const auto window = std::span(values).subspan(i - reach, 2 * reach + 1);
        EXPECT_EQ(medians[i], SortedMiddle(window)) << half_width << ", " << i << " of " << count;
      }
    }
  }
}

TEST(RunningMedian, RefusesANegativeWidthAndTooFewPlaces) {
  const std::vector<double> values(3);
  std::vector<double> medians(3);
  EXPECT_THROW(RunningMedian(values, -1, medians), ContractViolation);
  medians.pop_back();
  EXPECT_THROW(RunningMedian(values, 1, medians), ContractViolation);
}

}  // namespace
}  // namespace geon::recognition
