#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "procs/geon/process_group.h"

namespace geon::cli {

// What Debian's supervisor says of one process.
struct ProcessState {
  std::string name;
  std::string group;
  std::string state;   // RUNNING, STARTING, BACKOFF, FATAL, EXITED, STOPPED, ...
  std::string detail;  // "pid 4711, uptime 0:01:05", or why it is not running
  int pid = 0;
  int restarts = 0;  // since the group was started
};

// One supervisord a group, its socket, log and pid under the run directory.
class Supervisor {
 public:
  Supervisor(ProcessGroup group, Environment environment);

  // Whether this group's supervisord runs.
  bool IsUp() const;
  // Asks every program of the group whether it accepts its configuration, then starts supervisord.
  Status Start() const;
  // Stops the processes (SIGTERM, lasers off, devices safe) and supervisord; waits for the end.
  Status Stop() const;
  // Every process of the group; "DOWN" when the group is not up.
  std::vector<ProcessState> States() const;

  const ProcessGroup& group() const { return group_; }

 private:
  std::filesystem::path FileInRun(const std::string& folder, const std::string& name) const;
  std::optional<int> Pid() const;
  Status CheckConfigurations() const;
  Result<ProgramOutcome> Control(const std::string& word) const;

  ProcessGroup group_;
  Environment environment_;
};

// Parses `supervisorctl status`. Lines it does not understand are left out.
std::vector<ProcessState> ParseStates(const std::string& text, const std::string& group);
// How often each process was started again, told by a supervisord log.
int CountRestarts(const std::string& log, const std::string& process);

}  // namespace geon::cli
