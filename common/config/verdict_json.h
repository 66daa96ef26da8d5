#pragma once

#include <cstdint>
#include <string>

#include "sensor/geon_verdict.h"

namespace geon::config {

// The contract geon.verdict.v1: one JSON object without line breaks. `file` is what the verdict is
// about, `microseconds` how long the recognition took.
std::string SerializeVerdict(const sensor::GeonVerdict& verdict, const std::string& file,
                             int64_t microseconds);

}  // namespace geon::config
