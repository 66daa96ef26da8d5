#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <iostream>

#include "config/daemon_arguments.h"
#include "procs/simulator/simulator_arguments.h"

namespace {

std::atomic<bool> stop_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set by a signal handler");

void RequestStop(int /*signal*/) { stop_requested = true; }

}  // namespace

int main(int argc, char** argv) {
  using geon::simulator::Simulator;
  geon::simulator::SimulatorArguments arguments;
  if (const std::optional<int> exit_code = arguments.Parse(argc, argv)) return *exit_code;
  const auto settings = arguments.ReadSettings();
  if (!settings.ok()) {
    std::cerr << "geon-sim: the configuration is refused:\n" << settings.message() << '\n';
    return 2;
  }
  if (arguments.check_config) {
    std::cout << "geon-sim: world and configuration are good\n";
    return 0;
  }
  std::signal(SIGTERM, RequestStop);
  std::signal(SIGINT, RequestStop);
  const auto simulator = Simulator::Open(*settings);
  if (!simulator.ok()) {
    std::cerr << "geon-sim: " << simulator.message() << '\n';
    return 1;
  }
  std::cerr << "geon-sim: serving " << arguments.world.string() << " in "
            << settings->run_directory.string() << '\n';
  (*simulator)->Run(stop_requested);
  return 0;
}
