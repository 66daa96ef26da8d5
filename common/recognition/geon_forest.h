#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/geon_label.h"

namespace geon::recognition {

// A node of a tree: values[feature] <= threshold leads to `child`, else to child + 1. A leaf has
// feature -1, and `child` is its label.
struct ForestNode {
  int16_t feature = -1;
  int32_t child = 0;
  float threshold = 0.0F;
};

// A forest of decision trees that vote; a view of tables that live elsewhere.
//
// Source: Breiman, "Random forests", Machine Learning 45, 2001.
struct GeonForest {
  std::span<const ForestNode> nodes;
  std::span<const int32_t> roots;  // one a tree
  int features = 0;                // values a vote needs
  // The posterior is the votes (with a half vote more for each label) to this power, normalised:
  // fitted on scans that the trees have not seen.
  double sharpness_1 = 1.0;
  // From this posterior on an answer counts as decided.
  double decided_1 = 0.0;
};

using Posterior = std::array<double, kGeonLabelCount>;

// The votes of all trees for each label.
std::array<int, kGeonLabelCount> CountVotes(const GeonForest& forest,
                                            std::span<const float> values);

// The posterior that votes stand for.
Posterior PosteriorOfVotes(const std::array<int, kGeonLabelCount>& votes, double sharpness_1);

// The forest that `geon train` made, compiled in (trained_forest.inc).
const GeonForest& TrainedForest();

}  // namespace geon::recognition
