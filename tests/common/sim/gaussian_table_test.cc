#include "sim/gaussian_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geon::sim {
namespace {

TEST(GaussianTableTest, HasTheMomentsOfTheNormalDistribution) {
  double sum = 0, squares = 0, fourth = 0;
  for (const float x : GaussianTable::Table()) {
    sum += static_cast<double>(x);
    squares += std::pow(static_cast<double>(x), 2);
    fourth += std::pow(static_cast<double>(x), 4);
  }
  EXPECT_NEAR(sum / 65536, 0.0, 1e-6);
  EXPECT_NEAR(squares / 65536, 1.0, 1e-3);
  EXPECT_NEAR(fourth / 65536, 3.0, 2e-2);
}

TEST(GaussianTableTest, GrowsFromEndToEnd) {
  const auto& table = GaussianTable::Table();
  for (size_t k = 1; k < table.size(); ++k) ASSERT_GT(table[k], table[k - 1]);
  EXPECT_NEAR(static_cast<double>(GaussianTable::At(55133)), 1.0, 1e-3);  // 84.13 %
}

}  // namespace
}  // namespace geon::sim
