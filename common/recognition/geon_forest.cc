#include "recognition/geon_forest.h"

#include <cmath>
#include <numeric>
#include <string>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

#include "recognition/trained_forest.inc"

}  // namespace

std::array<int, kGeonLabelCount> CountVotes(const GeonForest& forest,
                                            std::span<const float> values) {
  Require(static_cast<int>(values.size()) == forest.features,
          "the forest wants " + std::to_string(forest.features) + " values, got " +
              std::to_string(values.size()));
  std::array<int, kGeonLabelCount> votes{};
  for (int32_t root : forest.roots) {
    const ForestNode* node = &forest.nodes[static_cast<size_t>(root)];
    while (node->feature >= 0) {
      const bool left = values[static_cast<size_t>(node->feature)] <= node->threshold;
      node = &forest.nodes[static_cast<size_t>(node->child + (left ? 0 : 1))];
    }
    ++votes[static_cast<size_t>(node->child)];
  }
  return votes;
}

Posterior PosteriorOfVotes(const std::array<int, kGeonLabelCount>& votes, double sharpness_1) {
  Posterior posterior{};
  for (size_t k = 0; k < votes.size(); ++k) posterior[k] = std::pow(votes[k] + 0.5, sharpness_1);
  const double sum = std::accumulate(posterior.begin(), posterior.end(), 0.0);
  for (double& p : posterior) p /= sum;
  return posterior;
}

const GeonForest& TrainedForest() {
  static const GeonForest forest{kNodes, kRoots, kFeatures, kSharpness_1, kDecided_1};
  return forest;
}

}  // namespace geon::recognition
