#include <spdlog/spdlog.h>

#include <optional>

#include "messaging/daemon.h"
#include "procs/planner/planner_node.h"

namespace {

int Serve(const geon::planner::PlannerConfig& config, bool exit_when_done,
          const geon::messaging::Daemon& daemon) {
  spdlog::info("the rig is taken {}", config.rig_source);
  const geon::planner::PlannerNode node(config, daemon.bus, daemon.loop, daemon.health, [&] {
    if (exit_when_done) daemon.loop->Stop();
  });
  daemon.loop->Run();
  using geon::sensor::MissionOutcome;
  const bool failed = node.outcome() != MissionOutcome::kRunning &&
                      node.outcome() != MissionOutcome::kNamed &&
                      node.outcome() != MissionOutcome::kSurveyed;
  return exit_when_done && failed ? 1 : 0;
}

constexpr const char* kToHelp =
    "X,Y: first drive to this place, metres ahead and to the left of where odometry started "
    "(planner.destination_m); then look for the geon";

}  // namespace

int main(int argc, char** argv) {
  constexpr const char* kProcess = "geon-planner";
  geon::config::DaemonArguments arguments(
      kProcess, "Runs the mission: finds a geon, drives up to it, has it scanned and named.",
      "geon-planner --seed 7 --exit-when-done\n  geon-planner --to 4.5,-1");
  std::optional<uint32_t> seed;
  std::string to;
  bool inventory = false, exit_when_done = false;
  arguments.AddNumber("--seed", &seed, "of the wandering, instead of the file's planner.seed");
  arguments.AddOption("--to", &to, kToHelp);
  arguments.AddFlag("--inventory", &inventory,
                    "name every geon in the pen, not just the first one (planner.inventory)");
  arguments.AddFlag(
      "--exit-when-done", &exit_when_done,
      "end with the mission: 0 when the geon was named or all were looked for, 1 when not");
  if (const auto exit_code = arguments.Parse(argc, argv)) return *exit_code;

  auto config = geon::planner::LoadPlannerConfig(arguments, to);
  if (!config.ok()) return arguments.RefuseConfiguration(config.status());
  if (arguments.check_config) return arguments.AcceptConfiguration();
  config->mission.inventory = config->mission.inventory || inventory;
  if (seed) config->mission.seed = *seed;
  return geon::messaging::RunDaemon(
      {{kProcess, geon::config::BuildVersion(), geon::config::FileHash(arguments.config_file)},
       config->bus_url},
      [&](const geon::messaging::Daemon& daemon) {
        return Serve(*config, exit_when_done, daemon);
      });
}
