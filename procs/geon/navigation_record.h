#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "procs/geon/drawn_run.h"
#include "procs/lockstep/navigation_trial.h"

namespace geon::cli {

// One run of `geon experiment navigation`, as results.json keeps it.
struct NavigationTrialRecord {
  int t = 0;
  std::string world;  // kind of the pen, or name of the file
  uint64_t seed = 0;  // of the pen and all noise
  lockstep::NavigationEnd expected = lockstep::NavigationEnd::kReached;
  lockstep::NavigationEnd end = lockstep::NavigationEnd::kTrapped;
  std::string why;                      // in the mission's words
  std::optional<double> first_sight_s;  // since the start, virtual seconds
  double end_s = 0.0;
  int contacts = 0;
  double hardest_contact_m_s = 0.0;
  double path_m = 0.0;

  bool right() const { return end == expected; }
};

// Everything the experiment found.
struct NavigationRecord {
  std::string planner;
  uint64_t seed = 1;
  std::string git;
  nlohmann::json conditions;                  // what was asked for; equal in all shards
  std::vector<NavigationTrialRecord> trials;  // by rising t
  std::vector<DrawnRun> maps;                 // the first wrong ones, by rising t
};

inline constexpr const char* kNavigationExperiment = "navigation";

// Contract geon.experiment.v1 with "experiment": "navigation". The same trials give the same bytes
// however they were spread over jobs and shards.
std::string NavigationRecordText(const NavigationRecord& record);
// Errors name `name`, the file.
Result<NavigationRecord> ParseNavigationRecord(const nlohmann::json& value,
                                               const std::string& name);
// The trials of all shards together. Errors: as JoinShards.
Result<NavigationRecord> MergeNavigationRecords(const std::vector<NavigationRecord>& shards);

// By kind of pen: runs, ends, contacts and times.
std::string NavigationTables(const NavigationRecord& record);
// One self-contained HTML page: the tables, and a map of every run that went wrong.
std::string NavigationPage(const NavigationRecord& record);

// What some of the trials came to.
struct NavigationSummary {
  int runs = 0;
  int right = 0;
  int reached = 0, unreachable = 0, none_found = 0, trapped = 0;
  int contacts = 0;
  double hardest_contact_m_s = 0.0;
  std::vector<double> times_s;  // from the first sight to the place, of those that got there
};
NavigationSummary Summarize(const NavigationRecord& record, const std::string& world = "");
// The kinds of pens (or files) in the order of their first trial.
std::vector<std::string> WorldsOf(const NavigationRecord& record);

}  // namespace geon::cli
