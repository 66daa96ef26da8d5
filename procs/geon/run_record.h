#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "messaging/bus_statistics.h"
#include "messaging/log_reader.h"
#include "sensor/base.h"
#include "sensor/geon_verdict.h"
#include "sensor/health.h"
#include "sensor/planner_state.h"
#include "sensor/scan_set.h"
#include "sensor/target_view.h"

namespace geon::cli {

// The planner was in one phase from `begin_s` to `end_s` (since the log's first event).
struct PhaseSpan {
  std::string phase;
  std::string text;  // what it said last in this phase
  double begin_s = 0.0;
  double end_s = 0.0;
};

// How one process fared.
struct ProcessHealth {
  sensor::Health last;
  sensor::HealthLevel worst = sensor::HealthLevel::kStarting;
  std::string worst_text;
  int starts = 0;  // pids seen
};

// What a log tells about one run, as far as people want to see it.
struct RunRecord {
  std::string file;
  int64_t events = 0;
  int64_t bytes = 0;
  double duration_s = 0.0;
  int64_t first_utime = 0;  // by the logger's clock
  messaging::LogDamage damage;
  messaging::BusStatistics channels;  // counted from the log's own messages

  std::optional<sensor::GeonVerdict> verdict;        // the last one
  std::optional<sensor::ScanPlan> plan;              // of the verdict's scan, or the last
  std::map<int32_t, sensor::RangeProfile> profiles;  // of that scan, the good ones
  int stripes_answered = 0;                          // of that scan, all attempts
  std::vector<sensor::TargetView> views;             // with a picture
  std::vector<PhaseSpan> phases;
  std::optional<sensor::PlannerState> last_state;
  std::vector<sensor::PlannerState> safe_states;  // a few with a safe polygon, spread over the run
  std::vector<sensor::BaseState> path;            // thinned to a few centimetres
  int32_t contacts = 0;
  std::map<std::string, ProcessHealth> health;  // by process
  std::map<std::string, sensor::Session> sessions;
};

Result<RunRecord> ReadRun(const std::filesystem::path& log);

}  // namespace geon::cli
