#include "procs/geon/spread.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geon::cli {

std::optional<Spread> SpreadOf(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto at = [&](double share_1) {
    return values[static_cast<size_t>(std::ceil(share_1 * static_cast<double>(values.size()))) - 1];
  };
  return Spread{at(0.5), at(0.95), values.back()};
}

nlohmann::json SpreadJson(std::vector<double> values) {
  const auto spread = SpreadOf(std::move(values));
  if (!spread) return nullptr;
  return {{"p50", spread->p50}, {"p95", spread->p95}, {"max", spread->max}};
}

}  // namespace geon::cli
