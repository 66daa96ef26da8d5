#include "sim/gaussian_table.h"

#include <cmath>
#include <cstddef>

namespace geon::sim {
namespace {

double NormalCdf(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

// Middle of the k-th of 65536 equally likely slices, by bisection.
std::array<float, 65536> MakeTable() {
  std::array<float, 65536> table{};
  double low = -6.0;
  for (size_t k = 0; k < table.size() / 2; ++k) {
    const double probability = (static_cast<double>(k) + 0.5) / static_cast<double>(table.size());
    double high = 0.0;
    double below = low;  // quantiles grow: the last one bounds the next from below
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (below + high);
      (NormalCdf(middle) < probability ? below : high) = middle;
    }
    low = below;
    table[k] = static_cast<float>(below);
    table[table.size() - 1 - k] = static_cast<float>(-below);
  }
  return table;
}

}  // namespace

const std::array<float, 65536>& GaussianTable::Table() {
  static const std::array<float, 65536> table = MakeTable();
  return table;
}

}  // namespace geon::sim
