#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "base/status.h"
#include "procs/simulator/simulator.h"

namespace geon::simulator {

// The command line of geon-sim. Exit codes: 0 ok, 1 failed, 2 usage or bad configuration.
class SimulatorArguments {
 public:
  SimulatorArguments();

  // Nothing to do but go on, or the exit code.
  std::optional<int> Parse(int argc, char** argv);

  // Reads and checks every file; nothing moves before.
  Result<SimulatorSettings> ReadSettings() const;

  std::filesystem::path world;
  bool check_config = false;

 private:
  CLI::App app_;
  std::filesystem::path run_directory_;
  std::filesystem::path truth_file_;
  std::filesystem::path config_file_;
  std::filesystem::path sim_config_file_;
  uint64_t seed_ = 1;
};

}  // namespace geon::simulator
