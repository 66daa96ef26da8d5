#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "base/status.h"
#include "geometry/sensor_rig.h"
#include "procs/geon/board_frames.h"

namespace geon::cli {

// `geon calibrate ...`, one subcommand each.
void AddCalibrateLutCommand(CLI::App* calibrate, int* exit_code);
void AddCalibrateRigCommand(CLI::App* calibrate, int* exit_code);
void AddCalibrateCompareCommand(CLI::App* calibrate, int* exit_code);

// The rig as drawn, of a robot file.
Result<geometry::SensorRig> LoadDrawing(const std::string& robot_file);

// What only the simulated robot's boards ask for; each excludes `frames`, the recorded ones.
struct SimulatedBoardArguments {
  std::string robot_file;  // the rig as drawn
  std::string sim_file;
  uint64_t seed = 1;
  BoardSteps steps;
};
SimulatedBoardArguments InstalledRobot();
void AddSimulatedBoardArguments(CLI::App& command, CLI::Option* frames,
                                SimulatedBoardArguments* arguments);
// The board before the simulated robot.
Result<BoardSeries> OpenSimulatedBoard(const SimulatedBoardArguments& arguments,
                                       sensor::Laser laser);

// YYYY-MM-DD, in UTC.
std::string Today();

}  // namespace geon::cli
