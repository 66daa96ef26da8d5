#include "active_vision/fuse_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "active_vision/view_table.h"
#include "base/contracts.h"
#include "base/plain_name.h"

namespace geon::active_vision {
namespace {

constexpr double kLeastPosterior_1 = 1e-4;  // no view rules a shape out for good

}  // namespace

FusionOptions TrainedFusion() { return TrainedViewTable().fusion; }

sensor::GeonVerdict FuseViews(std::span<const sensor::GeonVerdict> verdicts,
                              const FusionOptions& options) {
  Require(!verdicts.empty(), "FuseViews: a verdict is needed");
  sensor::GeonVerdict fused = verdicts.back();
  if (verdicts.size() == 1) return fused;
  std::array<double, kGeonLabelCount> log_posterior_1{};
  for (const sensor::GeonVerdict& verdict : verdicts) {
    for (size_t k = 0; k < kGeonLabelCount; ++k) {
      log_posterior_1[k] +=
          options.weight_1 * std::log(std::max(verdict.posterior[k], kLeastPosterior_1));
    }
  }
  const auto most = std::max_element(log_posterior_1.begin(), log_posterior_1.end());
  double sum_1 = 0.0;
  for (size_t k = 0; k < kGeonLabelCount; ++k) {
    fused.posterior[k] = std::exp(log_posterior_1[k] - *most);
    sum_1 += fused.posterior[k];
  }
  for (double& posterior_1 : fused.posterior) posterior_1 /= sum_1;
  const auto label = static_cast<size_t>(most - log_posterior_1.begin());
  fused.label = static_cast<GeonLabel>(label);
  fused.confidence = fused.posterior[label];
  fused.decided = fused.confidence >= options.decided_1;
  fused.reasons.push_back("seen from " + std::to_string(verdicts.size()) + " sides: together " +
                          PlainName(fused.label));
  return fused;
}

}  // namespace geon::active_vision
