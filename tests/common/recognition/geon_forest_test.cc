#include "recognition/geon_forest.h"

#include <gtest/gtest.h>

#include <array>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

// Two trees: value 0 above 1 is a cylinder, else value 1 above 0.5 an ellipsoid, else a cuboid; and
// one that always says cuboid.
constexpr ForestNode kTwoTrees[] = {{0, 1, 1.0F},  {1, 3, 0.5F},  {-1, 1, 0.0F},
                                    {-1, 0, 0.0F}, {-1, 2, 0.0F}, {-1, 0, 0.0F}};
constexpr int32_t kTwoRoots[] = {0, 5};
const GeonForest kForest{kTwoTrees, kTwoRoots, 2, 2.0, 0.5};

int VotesFor(GeonLabel label, std::array<float, 2> values) {
  return CountVotes(kForest, values)[static_cast<size_t>(label)];
}

TEST(GeonForest, EachTreeVotesOnce) {
  EXPECT_EQ(VotesFor(GeonLabel::kCuboid, {1.0F, 0.5F}), 2) << "a threshold itself goes left";
  EXPECT_EQ(VotesFor(GeonLabel::kCylinder, {1.5F, 0.0F}), 1);
  EXPECT_EQ(VotesFor(GeonLabel::kEllipsoid, {0.0F, 0.6F}), 1);
}

TEST(GeonForest, WantsAllItsValues) {
  const std::array<float, 1> one = {0.0F};
  EXPECT_THROW(CountVotes(kForest, one), ContractViolation);
}

TEST(PosteriorOfVotes, SumsToOneAndSharpens) {
  const std::array<int, kGeonLabelCount> votes = {6, 3, 1, 0, 0, 0, 0};
  const Posterior soft = PosteriorOfVotes(votes, 1.0), sharp = PosteriorOfVotes(votes, 3.0);
  double sum = 0.0;
  for (double p : sharp) sum += p;
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_NEAR(soft[0], 6.5 / 13.5, 1e-12);
  EXPECT_GT(sharp[0], soft[0]);
  EXPECT_GT(sharp[6], 0.0) << "no label is impossible";
}

TEST(TrainedForest, IsWhole) {
  const GeonForest& forest = TrainedForest();
  for (const ForestNode& node : forest.nodes) {
    if (node.feature < 0) {
      EXPECT_LT(node.child, kGeonLabelCount);
      continue;
    }
    EXPECT_LT(node.feature, forest.features);
    EXPECT_GT(node.child, 0);
    EXPECT_LT(static_cast<size_t>(node.child) + 1, forest.nodes.size());
  }
  EXPECT_GT(forest.decided_1, 0.0);
}

}  // namespace
}  // namespace geon::recognition
