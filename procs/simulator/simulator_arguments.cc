#include "procs/simulator/simulator_arguments.h"

#include "config/daemon_arguments.h"
#include "config/rig_config.h"
#include "sim/sim_config.h"
#include "sim/world_file.h"
#include "sim/world_scene.h"

namespace geon::simulator {

SimulatorArguments::SimulatorArguments()
    : world(config::InstalledFile("scripts/config/worlds/demo.yaml")),
      app_(
          "Simulates the robot and its world at the hardware boundary: serial lines and camera "
          "frames.",
          "geon-sim"),
      run_directory_(config::InstalledFile("run")),
      config_file_(config::InstalledFile("scripts/config/robot.yaml")),
      sim_config_file_(config::InstalledFile("scripts/config/sim.yaml")) {
  app_.set_version_flag("--version", "geon-sim " + config::BuildVersion());
  app_.add_option("--world", world, "world file")->capture_default_str();
  app_.add_option("--run-dir", run_directory_, "where devices and cameras appear")
      ->envname("GEON_RUN_DIR")
      ->capture_default_str();
  app_.add_option("--seed", seed_, "of all noise")->capture_default_str();
  app_.add_option("--truth", truth_file_,
                  "file for what really happens (default: RUN-DIR/truth.jsonl)");
  app_.add_option("--config", config_file_, "robot file: the rig as designed")
      ->envname("GEON_CONFIG")
      ->capture_default_str();
  app_.add_option("--sim-config", sim_config_file_,
                  "how the simulated robot differs from its design")
      ->capture_default_str();
  app_.add_flag("--check-config", check_config, "check world and configuration and exit");
  app_.footer(
      "Examples:\n  geon-sim --world scripts/config/worlds/box.yaml --seed 3\n"
      "Exit codes: 0 ok, 1 failed, 2 usage or bad configuration.");
}

std::optional<int> SimulatorArguments::Parse(int argc, char** argv) {
  try {
    app_.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app_.exit(error) == 0 ? 0 : 2;
  }
  return std::nullopt;
}

Result<SimulatorSettings> SimulatorArguments::ReadSettings() const {
  SimulatorSettings settings;
  const Result<sim::World> loaded = sim::LoadWorld(world);
  if (!loaded.ok()) return loaded.status();
  for (const sim::WorldObject& object : loaded->objects) {
    const auto mesh = sim::ObjectMesh(*loaded, object);
    if (!mesh.ok()) return mesh.status().In(world.string());
  }
  settings.world = *loaded;
  const Result<config::YamlDocument> robot = config::LoadRobotFile(config_file_, {"rig"});
  if (!robot.ok()) return robot.status();
  settings.rig = config::ReadDrawnRig(robot->root().Child("rig"));
  if (const Status status = robot->Finish(); !status.ok()) return status;
  const Result<sim::SimOptions> options = sim::LoadSimOptions(sim_config_file_);
  if (!options.ok()) return options.status();
  settings.options = *options;
  settings.seed = seed_;
  settings.run_directory = std::filesystem::absolute(run_directory_);
  settings.truth_file = truth_file_.empty() ? settings.run_directory / "truth.jsonl" : truth_file_;
  return settings;
}

}  // namespace geon::simulator
