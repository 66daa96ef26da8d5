#include "recognition/quantiles.h"

#include <gtest/gtest.h>

#include "tests/common/recognition/evidence_of.h"

namespace geon::recognition {
namespace {

TEST(Quantiles, InterpolateBetweenNeighbours) {
  EvidenceList evidence(true);
  AddQuantiles("q_", {4.0, 0.0, 3.0, 1.0, 2.0}, &evidence);
  EXPECT_DOUBLE_EQ(ValueOf(evidence, ".q_min"), 0.0);
  EXPECT_NEAR(ValueOf(evidence, ".q_10"), 0.4, 1e-6);
  EXPECT_DOUBLE_EQ(ValueOf(evidence, ".q_50"), 2.0);
  EXPECT_DOUBLE_EQ(ValueOf(evidence, ".q_max"), 4.0);
}

TEST(Quantiles, OfNothingAreZero) {
  EvidenceList evidence(true);
  AddQuantiles("q_", {}, &evidence);
  ASSERT_EQ(evidence.values().size(), 7U);
  for (float value : evidence.values()) EXPECT_EQ(value, 0.0F);
}

}  // namespace
}  // namespace geon::recognition
