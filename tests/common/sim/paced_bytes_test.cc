#include "sim/paced_bytes.h"

#include <gtest/gtest.h>

#include "base/contracts.h"

namespace geon::sim {
namespace {

TEST(PacedBytes, AByteTakesTenBitTimes) {
  PacedBytes line(9600);
  line.Push(std::vector<uint8_t>{1, 2}, 1.0);
  EXPECT_FALSE(line.Pop(1.001).has_value());
  EXPECT_EQ(line.Pop(1.00105), 1);
  EXPECT_FALSE(line.Pop(1.00205).has_value());
  EXPECT_EQ(line.Pop(1.0021), 2);
  EXPECT_TRUE(line.empty());
}

TEST(PacedBytes, WhatIsSentWhileTheLineIsBusyQueuesUp) {
  PacedBytes line(1000);  // 10 ms a byte
  line.Push(std::vector<uint8_t>{1, 2, 3}, 0.0);
  line.Push(std::vector<uint8_t>{4}, 0.005);
  EXPECT_NEAR(line.last_arrival_s(), 0.040, 1e-12);
  EXPECT_EQ(line.PopAll(0.0301).size(), 3u);
  EXPECT_EQ(line.PopAll(0.0401), std::vector<uint8_t>{4});
}

TEST(PacedBytes, RefusesASpeedThatIsNone) { EXPECT_THROW(PacedBytes(0), ContractViolation); }

}  // namespace
}  // namespace geon::sim
