#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "base/status.h"

namespace geon::cli {

// The shards of one experiment as one record, trials in the order of their `t`, whatever the order
// of the shards. `same(a, b)`: whether two shards are of one experiment; `add_worst(shard, &all)`
// takes over what each kept of its worst. Errors: no shard, shards of different experiments, a
// trial that is in two of them.
template <typename Record, typename Trial, typename Same, typename AddWorst>
Result<Record> JoinShards(const std::vector<Record>& shards, std::vector<Trial> Record::*trials,
                          Same same, AddWorst add_worst) {
  if (shards.empty()) return Status::Error("nothing to merge");
  Record all = shards.front();
  std::vector<Trial>& joined = all.*trials;
  for (size_t k = 1; k < shards.size(); ++k) {
    const Record& shard = shards[k];
    if (!same(shard, all)) {
      return Status::Error("shard " + std::to_string(k + 1) +
                           " is of another experiment (method, seed, build or conditions differ)");
    }
    joined.insert(joined.end(), (shard.*trials).begin(), (shard.*trials).end());
    add_worst(shard, &all);
  }
  std::sort(joined.begin(), joined.end(), [](const Trial& a, const Trial& b) { return a.t < b.t; });
  const auto twice = std::adjacent_find(joined.begin(), joined.end(),
                                        [](const Trial& a, const Trial& b) { return a.t == b.t; });
  if (twice != joined.end()) {
    return Status::Error("trial " + std::to_string(twice->t) + " is in two shards");
  }
  return all;
}

}  // namespace geon::cli
