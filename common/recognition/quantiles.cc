#include "recognition/quantiles.h"

#include <algorithm>
#include <array>

namespace geon::recognition {
namespace {

constexpr std::array<double, 7> kQuantiles = {0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0};
constexpr std::array<const char*, 7> kNames = {"min", "10", "25", "50", "75", "90", "max"};

double Quantile(const std::vector<double>& sorted, double share_1) {
  if (sorted.empty()) return 0.0;
  const double place = share_1 * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

void AddQuantiles(std::string_view name, std::vector<double> values, EvidenceList* evidence) {
  std::sort(values.begin(), values.end());
  for (size_t q = 0; q < kQuantiles.size(); ++q) {
    evidence->Add(name, kNames[q], Quantile(values, kQuantiles[q]));
  }
}

}  // namespace geon::recognition
