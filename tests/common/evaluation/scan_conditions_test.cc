#include "evaluation/scan_conditions.h"

#include <gtest/gtest.h>

namespace geon::evaluation {
namespace {

TEST(ScanConditions, StressesAreFoundByName) {
  EXPECT_EQ(FindStress("dropout")->faults.dropout_1, 0.10);
  EXPECT_EQ(FindStress("small")->scale_1, 0.6);
  EXPECT_TRUE(FindStress("realish")->floor);
  EXPECT_FALSE(FindStress("misplacement")->floor);
  EXPECT_FALSE(FindStress("nothing").has_value());
}

TEST(ScanConditions, NoStressLeavesOnlyTheNoise) {
  const FaultOptions faults = FindStress("none")->faults;
  EXPECT_EQ(faults.noise_px, 0.1);
  EXPECT_EQ(faults.outliers_1 + faults.dropout_1 + faults.speckle_px + faults.floor_cut_m, 0.0);
}

}  // namespace
}  // namespace geon::evaluation
