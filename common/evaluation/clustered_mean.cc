#include "evaluation/clustered_mean.h"

#include <algorithm>
#include <cmath>

namespace geon::evaluation {

void ClusteredMean::Count(double value_1) {
  present_.n_1 += 1.0;
  present_.sum_1 += value_1;
}

void ClusteredMean::EndCluster() {
  if (present_.n_1 == 0.0) return;
  n_ += static_cast<int>(present_.n_1);
  ++clusters_;
  sum_1_ += present_.sum_1;
  nn_1_ += present_.n_1 * present_.n_1;
  ns_1_ += present_.n_1 * present_.sum_1;
  ss_1_ += present_.sum_1 * present_.sum_1;
  present_ = {};
}

double ClusteredMean::mean_1() const { return n_ > 0 ? sum_1_ / n_ : 0.0; }

double ClusteredMean::EffectiveN() const {
  return n_ > 0 ? static_cast<double>(n_) * n_ / nn_1_ : 0.0;
}

Interval ClusteredMean::ShareInterval() const { return WilsonInterval(mean_1(), EffectiveN()); }

Interval ClusteredMean::MeanInterval() const {
  constexpr double kZ = 1.959963984540054;  // 97.5 % of the normal distribution
  const double mean = mean_1();
  const double scatter_1 = std::max(0.0, ss_1_ - 2.0 * mean * ns_1_ + mean * mean * nn_1_);
  const double half = n_ > 0 ? kZ * std::sqrt(scatter_1) / n_ : 0.0;
  return {mean - half, mean + half};
}

}  // namespace geon::evaluation
