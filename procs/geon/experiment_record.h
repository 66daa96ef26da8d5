#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/status.h"
#include "evaluation/confusion.h"
#include "procs/geon/worst_views.h"

namespace geon::cli {

// Everything an experiment over the viewing sphere found: what results.json holds.
struct ShapeRecord {
  std::string method;
  uint64_t seed = 1;
  std::string git;
  // What was asked for (range, noise, stress, ...): shards of one experiment agree in it.
  nlohmann::json conditions;
  std::vector<evaluation::Subject> subjects;
  std::vector<evaluation::ShapeTrial> trials;  // by rising t
  std::vector<WorstView> worst;                // of these trials, the worst first
};

// Contract geon.experiment.v1. The same trials give the same bytes however they were spread over
// jobs and shards; therefore "seconds" is null, and the time goes to timing.json beside it.
std::string RecordText(const ShapeRecord& record);

// Errors name `name`, the file.
Result<ShapeRecord> ParseRecord(const nlohmann::json& value, const std::string& name);

// The trials of all shards together, and the worst views of them all. Errors: other conditions,
// method, seed or build, or a trial that two of them have.
Result<ShapeRecord> MergeRecords(const std::vector<ShapeRecord>& shards);

// The tables of an experiment as people read them.
std::string RecordTables(const ShapeRecord& record);

}  // namespace geon::cli
