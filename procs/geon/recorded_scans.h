#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "messaging/log_reader.h"
#include "procs/recognizer/recognizer_config.h"
#include "sensor/geon_verdict.h"
#include "sensor/health.h"

namespace geon::cli {

// One scan of a log: what was said then and what the same messages give now.
struct ReplayedScan {
  int planned_stripes = 0;  // 0: the plan is not in the log
  int good_stripes = 0;
  std::optional<sensor::GeonVerdict> recorded;
  std::optional<sensor::GeonVerdict> replayed;
  bool identical = false;  // both there, and the same in every bit but seq
};

struct ReplayedLog {
  int64_t events = 0;
  int64_t unreadable = 0;  // whole events whose message is not good
  messaging::LogDamage damage;
  std::string recorded_calibration;       // hash; empty when the log does not tell
  std::map<int64_t, ReplayedScan> scans;  // by scan_id
  bool identical() const;                 // every recorded verdict came out again
};

// Runs the recorded plans and stripes through a scan assembler, as geon-recognizer did; where the
// log shows that it was started anew, so is the assembler. `progress` hears the fraction read.
Result<ReplayedLog> ReplayLog(const std::filesystem::path& log,
                              const recognizer::RecognizerConfig& config,
                              const std::optional<recognizer::StripeCalibration>& calibration,
                              const std::function<void(double)>& progress);

}  // namespace geon::cli
