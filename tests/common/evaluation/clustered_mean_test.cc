#include "evaluation/clustered_mean.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geon::evaluation {
namespace {

ClusteredMean Of(std::initializer_list<std::initializer_list<double>> clusters) {
  ClusteredMean mean;
  for (const auto& cluster : clusters) {
    for (const double value_1 : cluster) mean.Count(value_1);
    mean.EndCluster();
  }
  return mean;
}

TEST(ClusteredMean, IsTheMeanOfAllValues) {
  const ClusteredMean mean = Of({{1.0, 0.0, 1.0}, {1.0}});
  EXPECT_EQ(mean.n(), 4);
  EXPECT_EQ(mean.clusters(), 2);
  EXPECT_EQ(mean.mean_1(), 0.75);
}

TEST(ClusteredMean, LonelyValuesTellAsMuchAsIndependentOnes) {
  const ClusteredMean mean = Of({{1.0}, {0.0}, {1.0}, {1.0}});
  EXPECT_EQ(mean.EffectiveN(), 4.0);
  EXPECT_EQ(mean.ShareInterval().low_1, WilsonInterval({3, 4}).low_1);
}

TEST(ClusteredMean, ValuesOfEqualClustersTellAsMuchAsOneOfEach) {
  const ClusteredMean mean = Of({{1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}});
  EXPECT_EQ(mean.EffectiveN(), 2.0);
  EXPECT_EQ(mean.ShareInterval().high_1, WilsonInterval({1, 2}).high_1);
}

TEST(ClusteredMean, OneLargeClusterTellsLittle) {
  EXPECT_NEAR(Of({{1.0, 1.0, 1.0, 1.0}, {0.0}}).EffectiveN(), 25.0 / 17.0, 1e-12);
}

// Of lonely values: the textbook's mean +- 1.96 s / sqrt(n), s over n.
TEST(ClusteredMean, ScatterOfLonelyValuesIsTheirStandardError) {
  const ClusteredMean mean = Of({{1.0}, {2.0}, {3.0}, {6.0}});
  const double error = std::sqrt((4.0 + 1.0 + 0.0 + 9.0) / 4.0) / std::sqrt(4.0);
  EXPECT_NEAR(mean.MeanInterval().high_1 - mean.mean_1(), 1.96 * error, 1e-4);
  EXPECT_NEAR(mean.mean_1() - mean.MeanInterval().low_1, 1.96 * error, 1e-4);
}

TEST(ClusteredMean, AgreementWithinClustersWidensTheInterval) {
  const auto width = [](const ClusteredMean& mean) {
    return mean.MeanInterval().high_1 - mean.MeanInterval().low_1;
  };
  EXPECT_GT(width(Of({{1.0, 1.0}, {0.0, 0.0}})), width(Of({{1.0}, {1.0}, {0.0}, {0.0}})));
}

TEST(ClusteredMean, NothingIsNothing) {
  ClusteredMean mean;
  mean.EndCluster();
  EXPECT_EQ(mean.clusters(), 0);
  EXPECT_EQ(mean.mean_1(), 0.0);
  EXPECT_EQ(mean.ShareInterval().high_1, 1.0);
}

}  // namespace
}  // namespace geon::evaluation
