#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace geon::cli {

// Median, 95 % point and largest of some numbers.
struct Spread {
  double p50 = 0.0, p95 = 0.0, max = 0.0;
};
// Nothing of none.
std::optional<Spread> SpreadOf(std::vector<double> values);
// {p50, p95, max}, or null.
nlohmann::json SpreadJson(std::vector<double> values);

}  // namespace geon::cli
