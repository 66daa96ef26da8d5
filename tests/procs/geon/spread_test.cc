#include "procs/geon/spread.h"

#include <gtest/gtest.h>

namespace geon::cli {
namespace {

TEST(SpreadTest, MedianAndTailOfAFewNumbers) {
  const auto spread = SpreadOf({3.0, 1.0, 2.0});
  ASSERT_TRUE(spread.has_value());
  EXPECT_EQ(spread->p50, 2.0);
  EXPECT_EQ(spread->p95, 3.0);
  EXPECT_EQ(spread->max, 3.0);
  EXPECT_FALSE(SpreadOf({}).has_value());
}

TEST(SpreadTest, AsJson) {
  EXPECT_EQ(SpreadJson({2.0, 1.0}).dump(), R"({"max":2.0,"p50":1.0,"p95":2.0})");
  EXPECT_TRUE(SpreadJson({}).is_null());
}

}  // namespace
}  // namespace geon::cli
