#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "procs/geon/drawn_run.h"
#include "procs/lockstep/navigation_trial.h"

namespace geon::cli {

// What is known of a run that had a destination (`--barn`).
struct CourseRecord {
  std::string id;           // of its world
  double shortest_m = 0.0;  // way there
  double optimal_s = 0.0;   // that BARN's metric measures times by
  double left_m = 0.0;      // from where the run ended, straight on
};

// One run of `geon experiment navigation`, as results.json keeps it.
struct NavigationTrialRecord {
  int t = 0;
  std::string world;  // kind of the pen, name of the file, or part of the BARN worlds
  uint64_t seed = 0;  // of the pen and all noise
  lockstep::NavigationEnd expected = lockstep::NavigationEnd::kReached;
  lockstep::NavigationEnd end = lockstep::NavigationEnd::kTrapped;
  std::string why;                      // in the mission's words
  std::optional<double> first_sight_s;  // since the start, virtual seconds
  double end_s = 0.0;
  int contacts = 0;
  double hardest_contact_m_s = 0.0;
  double path_m = 0.0;
  std::optional<CourseRecord> course;

  bool right() const { return end == expected; }
  // Of a run with a course. How much longer than the shortest its way was, with what was left of
  // it.
  double length_ratio_1() const { return (path_m + course->left_m) / course->shortest_m; }
  // BARN's metric (Xiao et al. 2022): 0 without success, else from 0.125 to 0.5, by the optimal
  // time over its own; a robot that drives 0.4 m/s comes to 0.2 at best.
  double barn_score_1() const;
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
  // Of those that got there: from the first sight to the place; with a destination from the start.
  std::vector<double> times_s;
  // Of runs with a course, means; nothing without any.
  std::optional<double> length_ratio_1;  // of those that got there
  std::optional<double> barn_score_1;
};
NavigationSummary Summarize(const NavigationRecord& record, const std::string& world = "");
// The kinds of pens (or files) in the order of their first trial.
std::vector<std::string> WorldsOf(const NavigationRecord& record);

}  // namespace geon::cli
