#include <chrono>
#include <ctime>

#include "procs/geon/calibrate_commands.h"
#include "procs/geon/commands.h"

namespace geon::cli {

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
