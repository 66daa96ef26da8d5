#pragma once

#include <string>
#include <vector>

#include "procs/geon/health_watch.h"
#include "procs/geon/supervisor.h"

namespace geon::cli {

// One process as supervisor and as itself report it.
struct ProcessStatus {
  ProcessState state;
  bool speaks = true;   // geon-sim has no bus: running is all there is to know
  bool heard = false;   // on HEALTH_*, from this very pid
  std::string health;   // "ok", ..., or "silent"
  std::string text;     // why, when not ok
  int64_t rx_lost = 0;  // messages it missed
  double age_s = 0.0;   // of the last word

  // Runs, and says that it works.
  bool ready() const;
};

std::vector<ProcessStatus> CollectStatus(const std::vector<Supervisor>& supervisors,
                                         const HealthWatch& watch);

// A table for people, or one JSON object (geon.status.v1).
std::string StatusTable(const std::vector<ProcessStatus>& statuses);
std::string StatusJson(const std::vector<ProcessStatus>& statuses);

// The bus of the processes in the run directory: $LCM_DEFAULT_URL, else what `geon up` left there,
// else `bus: url:` of the robot file.
Result<std::string> BusUrlOfRun();
Status RememberBusUrl(const std::string& url);

}  // namespace geon::cli
