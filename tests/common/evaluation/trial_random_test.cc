#include "evaluation/trial_random.h"

#include <gtest/gtest.h>

#include <set>

namespace geon::evaluation {
namespace {

TEST(TrialRandom, DependsOnSeedAndTrialAlone) {
  EXPECT_EQ(TrialRandom(5, 17)(), TrialRandom(5, 17)());
  std::set<uint64_t> first;
  for (uint64_t seed = 0; seed < 30; ++seed) {
    for (uint64_t t = 0; t < 30; ++t) first.insert(TrialRandom(seed, t)());
  }
  EXPECT_EQ(first.size(), 900U);
}

TEST(NormalVector, DrawsZFirst) {
  std::mt19937_64 random(1), other(1);
  std::normal_distribution<double> gauss, again;
  const Eigen::Vector3d vector = NormalVector(random, gauss);
  for (int axis : {2, 1, 0}) EXPECT_EQ(vector[axis], again(other));
}

}  // namespace
}  // namespace geon::evaluation
