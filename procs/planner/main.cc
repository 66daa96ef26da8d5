#include <spdlog/spdlog.h>

#include <exception>
#include <optional>

#include "messaging/daemon_log.h"
#include "procs/planner/planner_node.h"

namespace {

constexpr const char* kProcess = "geon-planner";

int Run(const geon::planner::PlannerConfig& config, bool exit_when_done,
        const std::string& config_hash) {
  geon::messaging::StartLog(kProcess);
  geon::messaging::PollLoop loop;
  auto bus = geon::messaging::Bus::Open({config.bus_url, kProcess});
  if (!bus.ok()) {
    spdlog::error("{}", bus.message());
    return 3;
  }
  geon::messaging::HealthReporter health(bus->get(), &loop,
                                         {kProcess, geon::config::BuildVersion(), config_hash});
  const geon::planner::PlannerNode node(config, bus->get(), &loop, &health, [&] {
    if (exit_when_done) loop.Stop();
  });
  loop.Run();
  return exit_when_done && node.outcome() == geon::sensor::MissionOutcome::kFailed ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  geon::config::DaemonArguments arguments(
      kProcess, "Runs the mission: finds a geon, drives up to it, has it scanned and named.",
      "geon-planner --seed 7 --exit-when-done");
  std::optional<uint32_t> seed;
  bool exit_when_done = false;
  arguments.app().add_option("--seed", seed,
                             "of the wandering, instead of the file's planner.seed");
  arguments.app().add_flag("--exit-when-done", exit_when_done,
                           "end with the mission: 0 when the geon was named, 1 when not");
  if (const auto exit_code = arguments.Parse(argc, argv)) return *exit_code;

  auto config = geon::planner::LoadPlannerConfig(arguments);
  if (!config.ok()) return arguments.RefuseConfiguration(config.status());
  if (arguments.check_config) return arguments.AcceptConfiguration();
  if (seed) config->mission.seed = *seed;
  try {
    return Run(*config, exit_when_done, geon::config::FileHash(arguments.config_file));
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return 1;
  }
}
