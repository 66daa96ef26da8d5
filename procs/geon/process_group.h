#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/status.h"
#include "procs/geon/run_program.h"

namespace geon::cli {

// Processes that are started and stopped together: scripts/supervisor/<name>.conf.
struct ProcessGroup {
  std::string name;  // "sim", "robot", "workstation"
  std::filesystem::path conf;
  std::vector<std::string> processes;  // as supervisor and HEALTH_ channels name them
  std::vector<std::string> programs;   // binary of each, without folder
};

// In the order of their start.
const std::vector<std::string>& ProcessGroupNames();
Result<ProcessGroup> LoadProcessGroup(const std::string& name);

// $GEON_RUN_DIR, else run/ of the source tree; absolute.
std::filesystem::path RunDirectory();
// The folder of this very program.
std::filesystem::path BinDirectory();

struct UpOptions {
  std::filesystem::path world;
  int seed = 1;
  bool simulated_devices = false;
  std::string lcm_url;
};

// Everything a conf file refers to as %(ENV_...)s. A real robot's devices are where the robot file
// says; simulated ones where simulated_devices.env says; our own environment beats both.
Result<Environment> GroupEnvironment(const UpOptions& options);

// KEY=VALUE lines with # comments; ${GEON_RUN_DIR} stands for `run_directory`.
Result<Environment> ReadEnvironmentFile(const std::filesystem::path& file,
                                        const std::filesystem::path& run_directory);

}  // namespace geon::cli
