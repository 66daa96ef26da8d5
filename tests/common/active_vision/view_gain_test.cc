#include "active_vision/view_gain.h"

#include <gtest/gtest.h>

#include "base/contracts.h"

namespace geon::active_vision {
namespace {

using Posterior = std::array<double, kGeonLabelCount>;

// A table whose every number says where it stands: first, second, turn.
ViewGainTable Numbered() {
  ViewGainTable table{};
  for (size_t i = 0; i < table.size(); ++i) {
    for (size_t j = 0; j < table.size(); ++j) {
      for (size_t k = 0; k < kViewTurns; ++k) {
        table[i][j][k] = static_cast<double>(100 * i + 10 * j + k + 1);
      }
    }
  }
  return table;
}

TEST(LikeliestTwo, AreFoundWhereverTheyStand) {
  for (size_t first = 0; first < kGeonLabelCount; ++first) {
    for (size_t second = 0; second < kGeonLabelCount; ++second) {
      if (first == second) continue;
      Posterior posterior_1;
      posterior_1.fill(0.02);
      posterior_1[first] = 0.6;
      posterior_1[second] = 0.3;
      EXPECT_EQ(LikeliestTwo(posterior_1), (std::array{first, second}));
    }
  }
}

TEST(LikeliestTwo, OfEqualsTheFirst) {
  Posterior posterior_1;
  posterior_1.fill(1.0 / kGeonLabelCount);
  EXPECT_EQ(LikeliestTwo(posterior_1), (std::array<size_t, 2>{0, 1}));
  EXPECT_EQ(LikeliestTwo({0.1, 0.1, 0.3, 0.1, 0.3, 0.05, 0.05}), (std::array<size_t, 2>{2, 4}));
  EXPECT_EQ(LikeliestTwo({0.2, 0.4, 0.2, 0.2, 0.0, 0.0, 0.0}), (std::array<size_t, 2>{1, 0}));
}

TEST(ViewGain, IsThatOfTheTwoLikeliestLabelsAndTheTurn) {
  const Posterior posterior_1 = {0.3, 0.0, 0.0, 0.0, 0.6, 0.1, 0.0};
  for (int turns = 1; turns <= kViewTurns; ++turns) {
    EXPECT_EQ(ViewGain(Numbered(), posterior_1, turns), 400.0 + turns);
  }
}

TEST(ViewGain, KnowsNoOtherTurns) {
  const Posterior posterior_1 = {0.6, 0.4};
  EXPECT_THROW(ViewGain(posterior_1, 0), ContractViolation);
  EXPECT_THROW(ViewGain(posterior_1, kViewTurns + 1), ContractViolation);
}

}  // namespace
}  // namespace geon::active_vision
