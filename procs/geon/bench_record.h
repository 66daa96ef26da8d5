#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "evaluation/confusion.h"
#include "procs/geon/spread.h"
#include "procs/geon/worst_views.h"

namespace geon::cli {

// One run on the bench, as results.json keeps it.
struct BenchTrialRecord {
  int t = 0;
  evaluation::Subject subject;
  double range_m = 0.0;
  double yaw_deg = 0.0;
  std::optional<GeonLabel> answer;  // nothing: the mission ended without a verdict, which is wrong
  double confidence = 0.0;
  bool decided = false;
  std::string end;  // in the mission's words
  // Virtual seconds until the end, from the first sight of the target's colour and from when the
  // whole target was in view.
  std::optional<double> from_sight_s;
  std::optional<double> from_view_s;
  // By profile: how far beside its quarter it lies, of the target's box.
  std::vector<double> misplaced_1;

  bool right() const { return answer == subject.truth; }
};

// Everything `geon experiment bench` found.
struct BenchRecord {
  std::string method;
  uint64_t seed = 1;
  std::string git;
  nlohmann::json conditions;             // what was asked for; equal in all shards
  std::vector<BenchTrialRecord> trials;  // by rising t
  std::vector<WorstView> worst;          // of these trials, the worst first
};

inline constexpr const char* kBenchExperiment = "bench";

// Contract geon.experiment.v1 with "experiment": "bench". The same trials give the same bytes
// however they were spread over jobs and shards.
std::string BenchRecordText(const BenchRecord& record);
// Errors name `name`, the file.
Result<BenchRecord> ParseBenchRecord(const nlohmann::json& value, const std::string& name);
// The trials of all shards together. Errors: other conditions, method, seed or build, or a trial
// that two of them have.
Result<BenchRecord> MergeBenchRecords(const std::vector<BenchRecord>& shards);

// What was found at one range: one row a geon, with the runs that gave no answer.
struct BenchRange {
  double range_m = 0.0;
  std::vector<evaluation::ConfusionRow> rows;  // one for each geon that was shown, answers only
  std::vector<int> unanswered;                 // of each row
  evaluation::SuccessRate all;                 // a run without an answer is wrong
};
std::vector<BenchRange> BenchRanges(const BenchRecord& record);

// Virtual seconds of the runs that gave an answer: from the first sight, from the whole target in
// view.
std::vector<double> SightTimes(const BenchRecord& record);
std::vector<double> ViewTimes(const BenchRecord& record);
// How far beside their quarters stripes lie, without sign, of all trials.
std::vector<double> Misplacements(const BenchRecord& record);

// Tables 6.8-6.10 as people read them, the thesis's figures beside ours.
std::string BenchTables(const BenchRecord& record);

}  // namespace geon::cli
