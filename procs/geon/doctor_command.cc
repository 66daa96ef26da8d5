#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "config/daemon_arguments.h"
#include "procs/geon/commands.h"
#include "procs/geon/floor_check.h"
#include "procs/geon/setup_checks.h"

namespace geon::cli {
namespace {

using State = SetupCheck::State;

struct DoctorArguments {
  std::string robot_file = config::InstalledFile("scripts/config/robot.yaml").string();
  std::vector<std::string> logs;
  bool no_devices = false;
  bool json = false;
};

const char* Word(State state) {
  switch (state) {
    case State::kGood:
      return "good";
    case State::kNote:
      return "note";
    case State::kNotReady:
      return "not ready";
    case State::kBad:
      return "bad";
  }
  return "";
}

SetupCheck CheckLogs(const std::vector<std::string>& logs) {
  std::vector<sensor::RangeProfile> all;
  for (const std::string& log : logs) {
    const auto profiles = FloorProfiles(log);
    if (!profiles.ok()) return {"floor stripe", State::kBad, profiles.message()};
    all.insert(all.end(), profiles->begin(), profiles->end());
  }
  return JudgeFloor(MeasureFloor(all));
}

int Examine(const DoctorArguments& arguments) {
  std::vector<SetupCheck> checks;
  const auto add = [&checks](const std::vector<SetupCheck>& more) {
    checks.insert(checks.end(), more.begin(), more.end());
  };
  add(CheckPrograms(arguments.robot_file));
  add(CheckCalibrations(arguments.robot_file));
  if (!arguments.no_devices) add(CheckDevices(arguments.robot_file));
  add(CheckBus(arguments.robot_file));
  if (!arguments.logs.empty()) checks.push_back(CheckLogs(arguments.logs));

  const auto any = [&checks](State state) {
    return std::any_of(checks.begin(), checks.end(),
                       [state](const SetupCheck& check) { return check.state == state; });
  };
  const int exit_code = any(State::kBad) ? kFailed : any(State::kNotReady) ? kNotReady : kOk;
  if (arguments.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const SetupCheck& check : checks) {
      list.push_back({{"check", check.name}, {"state", Word(check.state)}, {"text", check.text}});
    }
    const nlohmann::ordered_json root = {
        {"format", "geon.doctor.v1"}, {"ok", exit_code == kOk}, {"checks", list}};
    std::cout << root.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
              << "\n";
  } else {
    for (const SetupCheck& check : checks) {
      std::cout << Word(check.state) << "  " << check.name << ": " << check.text << "\n";
    }
  }
  return exit_code;
}

}  // namespace

void AddDoctorCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<DoctorArguments>();
  CLI::App* command = app.add_subcommand(
      "doctor", "Checks a set-up: files, calibrations, devices, receive buffer, floor stripe.");
  command->add_option("--config", arguments->robot_file, "robot file")->capture_default_str();
  command->add_option("--log", arguments->logs,
                      "recorded runs: whether the floor is still where the calibration has it");
  command->add_flag("--no-devices", arguments->no_devices,
                    "leave out ports and cameras (simulated robot, workstation)");
  command->add_flag("--json", arguments->json, "one JSON object (geon.doctor.v1)");
  command->footer(
      "Examples:\n  geon doctor\n  geon doctor --no-devices --log logs/sample.lcmlog\n"
      "Exit codes: 0 all good, 1 something is wrong, 3 a device or kernel setting is missing.");
  command->callback([arguments, exit_code] { *exit_code = Examine(*arguments); });
}

}  // namespace geon::cli
