#include "evaluation/success_rate.h"

#include <algorithm>
#include <cmath>

namespace geon::evaluation {

Interval WilsonInterval(const SuccessRate& rate) { return WilsonInterval(rate.value_1(), rate.n); }

Interval WilsonInterval(double share_1, double n_1) {
  constexpr double kZ = 1.959963984540054;  // 97.5 % of the normal distribution
  if (n_1 <= 0.0) return {};
  const double n = n_1;
  const double p = share_1;
  const double middle = (p + kZ * kZ / (2.0 * n)) / (1.0 + kZ * kZ / n);
  const double half =
      kZ / (1.0 + kZ * kZ / n) * std::sqrt(p * (1.0 - p) / n + kZ * kZ / (4.0 * n * n));
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace geon::evaluation
