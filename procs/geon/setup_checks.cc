#include "procs/geon/setup_checks.h"

#include <optional>

#include "config/daemon_arguments.h"
#include "config/rig_config.h"
#include "messaging/bus_url.h"
#include "procs/geon/process_group.h"
#include "procs/geon/run_program.h"
#include "procs/recognizer/recognizer_config.h"

namespace geon::cli {
namespace {

using State = SetupCheck::State;

std::string WithoutLastNewline(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

// A text value of the robot file, by the keys that lead to it; empty where it is not.
std::string ValueAt(const std::filesystem::path& robot_file, const std::vector<std::string>& keys) {
  const Result<config::YamlDocument> document = config::YamlDocument::Load(robot_file);
  if (!document.ok()) return "";
  config::YamlSection section = document->root();
  for (size_t k = 0; k + 1 < keys.size(); ++k) {
    if (!section.Has(keys[k])) return "";
    section = section.Child(keys[k]);
  }
  std::string value;
  section.ReadOptional(keys.back(), &value);
  return value;
}

SetupCheck CheckDevice(const std::string& name, const std::string& path) {
  std::error_code error;
  if (std::filesystem::exists(path, error)) return {name, State::kGood, path};
  return {name, State::kNotReady,
          path + " is not there: plug it in, or name another in the robot file"};
}

}  // namespace

std::vector<SetupCheck> CheckPrograms(const std::filesystem::path& robot_file) {
  const std::vector<std::vector<std::string>> programs = {
      {"geon-color-camera", "--channel", "head"},
      {"geon-color-camera", "--channel", "floor"},
      {"geon-stripe-camera"},
      {"geon-ptu"},
      {"geon-base"},
      {"geon-planner"},
      {"geon-recognizer"}};
  std::vector<SetupCheck> checks;
  for (const std::vector<std::string>& program : programs) {
    std::vector<std::string> words = program;
    words.front() = (BinDirectory() / program.front()).string();
    words.insert(words.end(), {"--check-config", "--config", robot_file.string()});
    const std::string name = program.front() + (program.size() > 1 ? " " + program.back() : "");
    std::error_code error;
    if (!std::filesystem::exists(words.front(), error)) {
      checks.push_back({name, State::kNotReady, words.front() + " is not built: scripts/build"});
      continue;
    }
    const Result<ProgramOutcome> outcome = RunProgram(words, {});
    if (!outcome.ok()) {
      checks.push_back({name, State::kBad, outcome.message()});
    } else {
      checks.push_back({name, outcome->exit_code == 0 ? State::kGood : State::kBad,
                        WithoutLastNewline(outcome->output)});
    }
  }
  return checks;
}

std::vector<SetupCheck> CheckCalibrations(const std::filesystem::path& robot_file) {
  const auto config = recognizer::LoadRecognizerConfig(robot_file, "");
  if (!config.ok()) return {{"rig", State::kBad, config.message()}};
  std::vector<SetupCheck> checks;
  const bool drawn = ValueAt(robot_file, {"rig", "calibrated"}).empty();
  checks.push_back({"rig", drawn ? State::kNote : State::kGood,
                    drawn ? "taken as drawn: good enough to point the head, not to measure; geon "
                            "calibrate rig -o FILE, then rig.calibrated: FILE"
                          : config->rig_source});
  const auto tables = recognizer::LoadCalibration(*config);
  if (!tables.ok()) {
    checks.push_back({"look-up tables", State::kBad, tables.message()});
  } else if (tables->has_value()) {
    checks.push_back(
        {"look-up tables", State::kGood,
         (*tables)->directory + ", " + (*tables)->horizontal.date + ", " + (*tables)->hash});
  } else if (drawn) {
    checks.push_back({"ranging", State::kBad,
                      "recognizer.ranging is rig, but the rig is only drawn: calibrate it, or set "
                      "ranging: lut"});
  }
  return checks;
}

std::vector<SetupCheck> CheckDevices(const std::filesystem::path& robot_file) {
  std::vector<SetupCheck> checks;
  const std::vector<std::pair<std::string, std::vector<std::string>>> ports = {
      {"pan-tilt unit", {"ptu", "port"}},
      {"base", {"base", "port"}},
      {"laser board", {"stripe_camera", "lasers", "port"}}};
  for (const auto& [name, keys] : ports)
    checks.push_back(CheckDevice(name, ValueAt(robot_file, keys)));
  for (const auto& [name, section] :
       {std::pair<std::string, std::string>{"head camera", "color_camera"},
        {"floor camera", "floor_camera"},
        {"B/W camera", "stripe_camera"}}) {
    const std::string source = ValueAt(robot_file, {section, "source"});
    constexpr std::string_view kV4l2 = "v4l2:";
    if (source.compare(0, kV4l2.size(), kV4l2) == 0) {
      checks.push_back(CheckDevice(name, source.substr(kV4l2.size())));
    } else {
      checks.push_back({name, State::kNote, source + ": no device that could be looked for"});
    }
  }
  return checks;
}

std::vector<SetupCheck> CheckBus(const std::filesystem::path& robot_file) {
  const std::string url = messaging::WithReceiveBuffer(ValueAt(robot_file, {"bus", "url"}));
  const auto limits = messaging::ReadKernelBufferLimits();
  if (!limits) return {{"receive buffer", State::kNote, "the kernel does not tell its limits"}};
  const auto warning = messaging::ReceiveBufferWarning(url, *limits);
  if (warning) return {{"receive buffer", State::kNotReady, *warning}};
  return {{"receive buffer", State::kGood, url}};
}

}  // namespace geon::cli
