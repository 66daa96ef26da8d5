#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "evaluation/confusion.h"
#include "procs/geon/drawn_run.h"
#include "sensor/planner_state.h"

namespace geon::cli {

// One geon of a pen, and what the mission found where it stands.
struct RobotGeonRecord {
  GeonLabel truth = GeonLabel::kCuboid;
  std::string place;  // floor or box
  bool found = false;
  std::optional<GeonLabel> label;  // nothing: it was never scanned
  bool decided = false;
  int views = 0;
  double off_m = 0.0;  // from where it stands to where the mission says; if found

  bool right() const { return label == truth; }
};

// One mission of `geon experiment robot`, as results.json keeps it. Times are virtual, from its
// start.
struct RobotTrialRecord {
  int t = 0;
  uint64_t seed = 0;            // of the world and of all noise
  std::string world;            // name of the file; empty: a random world
  evaluation::Subject subject;  // what the geon is, what it stands on (floor, box), how it lies
  sensor::MissionOutcome end = sensor::MissionOutcome::kRunning;  // still: time was over
  std::optional<GeonLabel> label;  // of the verdict, decided or not; nothing: there was none
  double confidence = 0.0;
  bool decided = false;
  int views = 0;    // scans that the verdict rests on
  std::string why;  // in the mission's words
  std::optional<double> first_sight_s;
  double end_s = 0.0;
  int contacts = 0;
  double hardest_contact_m_s = 0.0;
  double path_m = 0.0;
  std::vector<RobotGeonRecord> geons;  // of the pen
  int others = 0;                      // findings where there is no geon

  bool surveyed() const { return geons.size() > 1; }  // all were to be named
  bool reached() const { return label.has_value() || end == sensor::MissionOutcome::kSurveyed; }
  bool named() const { return end == sensor::MissionOutcome::kNamed; }
  // With an answer that the mission stands by.
  bool concluded() const { return named() || end == sensor::MissionOutcome::kSurveyed; }
  bool right() const {
    if (surveyed()) return others == 0 && AllGeonsRight();
    return named() && label == subject.truth;
  }
  bool AllGeonsRight() const {
    return std::all_of(geons.begin(), geons.end(), [](const auto& geon) { return geon.right(); });
  }
  bool right_guess() const { return !surveyed() && !named() && label == subject.truth; }
  bool unreachable() const { return end == sensor::MissionOutcome::kUnreachable; }
  bool none_found() const { return end == sensor::MissionOutcome::kNoneFound; }
  // None found: wrongly. A survey whose time was over is right when all its geons are named by
  // then.
  bool trapped() const { return !reached() && !unreachable() && !right(); }
};

// The first run, told by what the head's camera saw whenever the mission went over to another
// phase.
struct RobotFilm {
  struct Still {
    double time_s = 0.0;
    std::string phase;  // that begins
    std::string text;   // why
    Eigen::Vector2d place_m{0.0, 0.0};
    std::string picture_uri;  // empty: there was no new one
  };
  DrawnRun run;
  std::vector<Still> stills;
};

// Everything the experiment found.
struct RobotRecord {
  std::string method;  // of recognition
  uint64_t seed = 1;
  std::string git;
  nlohmann::json conditions;             // what was asked for; equal in all shards
  std::vector<RobotTrialRecord> trials;  // by rising t
  std::vector<DrawnRun> maps;            // the first that are not right, by rising t
  std::optional<RobotFilm> film;         // of trial 0, in the shard that has it
};

inline constexpr const char* kRobotExperiment = "robot";

// Contract geon.experiment.v1 with "experiment": "robot". The same trials give the same bytes
// however they were spread over jobs and shards.
std::string RobotRecordText(const RobotRecord& record);
// Errors name `name`, the file.
Result<RobotRecord> ParseRobotRecord(const nlohmann::json& value, const std::string& name);
// The trials of all shards together. Errors: as JoinShards.
Result<RobotRecord> MergeRobotRecords(const std::vector<RobotRecord>& shards);

// What the runs came to; every run is right, wrong, undecided, trapped or unreachable.
struct RobotSummary {
  evaluation::SuccessRate right;  // named, with the true label; of all runs
  int wrong = 0;                  // named, with another
  int undecided = 0;              // a verdict that the mission did not stand by, ...
  int right_guesses = 0;          // ... though it was right
  int trapped = 0;                // no verdict, and no word that there is no way
  int unreachable = 0;
  int contacts = 0;
  double hardest_contact_m_s = 0.0;
  std::vector<double> times_s;    // from the start to the verdict, of those that reached one
  evaluation::SuccessRate geons;  // found and rightly named; of all in the pens
  int others = 0;                 // findings where there is no geon
  std::vector<double> off_m;      // of the positions of those found
  std::vector<int> views;         // runs (of one geon) that took 1, 2, ... views
};
// Of the runs with the geon on `place`; empty: of all.
RobotSummary Summarize(const RobotRecord& record, const std::string& place = "");
// On which places the geon stood: floor, box or both.
std::vector<std::string> PlacesOf(const RobotRecord& record);

// By place: a heading and rows of cells, the thesis's figures among them; for people.
std::vector<std::vector<std::string>> RobotTable(const RobotRecord& record);
// The same as text, and what the thesis counted.
std::string RobotTables(const RobotRecord& record);
// How many views it took, and of all geons of the pens how many were found, and how far off.
std::string RobotNotes(const RobotRecord& record);
inline constexpr const char* kThesisRunsNote =
    "The thesis's percentages are of runs that came near the geon: those in which the robot was "
    "trapped it left out. It came there \"in most cases within 30 seconds\".";

// One self-contained HTML page: the table, the film of the first run, truth by answer, and a map of
// every run that is not right.
std::string RobotPage(const RobotRecord& record);

}  // namespace geon::cli
