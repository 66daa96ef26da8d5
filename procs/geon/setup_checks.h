#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geon::cli {

// One thing that `geon doctor` looked at.
struct SetupCheck {
  enum class State {
    kGood,
    kNote,      // works, but somebody should know
    kNotReady,  // something outside is missing: a device, a kernel setting
    kBad,       // wrong: a file, a calibration
  };
  std::string name;
  State state = State::kGood;
  std::string text;  // what was found, and what to do
};

// The robot file by every program that reads it (each is asked with --check-config).
std::vector<SetupCheck> CheckPrograms(const std::filesystem::path& robot_file);
// The rig file that the robot file names, and the look-up tables.
std::vector<SetupCheck> CheckCalibrations(const std::filesystem::path& robot_file);
// Serial ports and cameras that the robot file names.
std::vector<SetupCheck> CheckDevices(const std::filesystem::path& robot_file);
// The receive buffer of the bus.
std::vector<SetupCheck> CheckBus(const std::filesystem::path& robot_file);

}  // namespace geon::cli
