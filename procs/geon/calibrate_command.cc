#include <chrono>
#include <ctime>

#include "config/daemon_arguments.h"
#include "config/rig_config.h"
#include "procs/geon/calibrate_commands.h"
#include "procs/geon/commands.h"
#include "sim/sim_config.h"

namespace geon::cli {

Result<geometry::SensorRig> LoadDrawing(const std::string& robot_file) {
  Result<config::YamlDocument> robot = config::LoadRobotFile(robot_file, {"rig"});
  if (!robot.ok()) return robot.status();
  const geometry::SensorRig rig = config::ReadDrawnRig(robot->root().Child("rig"));
  if (const Status status = robot->Finish(); !status.ok()) return status;
  return rig;
}

SimulatedBoardArguments InstalledRobot() {
  SimulatedBoardArguments arguments;
  arguments.robot_file = config::InstalledFile("scripts/config/robot.yaml").string();
  arguments.sim_file = config::InstalledFile("scripts/config/sim.yaml").string();
  return arguments;
}

void AddSimulatedBoardArguments(CLI::App& command, CLI::Option* frames,
                                SimulatedBoardArguments* arguments) {
  const auto simulated = [&](CLI::Option* option) {
    option->excludes(frames)->capture_default_str();
  };
  BoardSteps& steps = arguments->steps;
  simulated(
      command.add_option("--sim-config", arguments->sim_file, "What the simulated robot is like"));
  simulated(command.add_option("--seed", arguments->seed,
                               "Of the frames' noise; which robot it is, sim.yaml says"));
  simulated(
      command.add_option("--from-m", steps.from_m, "Nearest board")->check(CLI::Range(0.1, 10.0)));
  simulated(
      command.add_option("--to-m", steps.to_m, "Farthest board")->check(CLI::Range(0.1, 10.0)));
  simulated(command.add_option("--step-m", steps.step_m, "Between boards")
                ->check(CLI::Range(0.0001, 1.0)));
  simulated(command.add_option("--frames-per-step", steps.frames, "Averaged at each distance")
                ->check(CLI::Range(1, 1000)));
}

Result<BoardSeries> OpenSimulatedBoard(const SimulatedBoardArguments& arguments,
                                       sensor::Laser laser) {
  const Result<geometry::SensorRig> drawn = LoadDrawing(arguments.robot_file);
  if (!drawn.ok()) return drawn.status();
  const Result<sim::SimOptions> options = sim::LoadSimOptions(arguments.sim_file);
  if (!options.ok()) return options.status();
  return SimulatedBoard(*drawn, options->renderer, arguments.seed, laser, arguments.steps);
}

std::string Today() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[16];
  std::strftime(text, sizeof(text), "%Y-%m-%d", &utc);
  return text;
}

void AddCalibrateCommand(CLI::App& app, int* exit_code) {
  CLI::App* command =
      app.add_subcommand("calibrate", "Calibrates the range finder, or the whole rig.");
  command->require_subcommand(1);
  AddCalibrateLutCommand(command, exit_code);
  AddCalibrateRigCommand(command, exit_code);
  AddCalibrateCompareCommand(command, exit_code);
}

}  // namespace geon::cli
