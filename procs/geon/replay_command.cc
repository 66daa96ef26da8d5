#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "config/daemon_arguments.h"
#include "config/verdict_json.h"
#include "procs/geon/commands.h"
#include "procs/geon/progress.h"
#include "procs/geon/recognition_arguments.h"
#include "procs/geon/recorded_scans.h"
#include "procs/geon/verdict_text.h"

namespace geon::cli {
namespace {

struct ReplayArguments {
  std::string log;
  std::string config_file = config::InstalledFile("scripts/config/robot.yaml").string();
  std::string calibration;
  RecognitionArguments recognition;
  bool json = false;
};

// What the reader of the result must know about the log and the set-up.
std::vector<std::string> Warnings(const ReplayedLog& log, const std::string& calibration_hash) {
  std::vector<std::string> warnings;
  if (log.damage.any()) {
    warnings.push_back("the log is damaged (" + messaging::Describe(log.damage) +
                       "); what is whole was used");
  }
  if (log.unreadable > 0) {
    warnings.push_back(std::to_string(log.unreadable) + " messages could not be decoded");
  }
  if (log.recorded_calibration.empty()) {
    warnings.emplace_back("the log does not tell which calibration was in use");
  } else if (log.recorded_calibration != calibration_hash) {
    warnings.push_back("recorded with calibration " + log.recorded_calibration +
                       ", replayed with " + calibration_hash + ": verdicts may differ");
  }
  return warnings;
}

// The method of the recorded verdicts: that of the last, where there is any.
std::optional<recognition::Method> RecordedMethod(const ReplayedLog& log) {
  std::optional<recognition::Method> method;
  for (const auto& [id, scan] : log.scans) {
    if (scan.recorded) method = recognition::MethodFromString(scan.recorded->method);
  }
  return method;
}

std::string Comparison(const ReplayedScan& scan, bool changed) {
  if (scan.identical) return "identical to the recorded verdict, evidence included";
  if (scan.recorded && scan.replayed) {
    return "the recorded verdict was " + PlainName(scan.recorded->label) +
           (changed ? " (by other options)" : ": NOT the same verdict and evidence");
  }
  if (scan.recorded) {
    return "recorded as " + PlainName(scan.recorded->label) + ", not reproduced: the log holds " +
           std::to_string(scan.good_stripes) + " good stripes of " +
           std::to_string(scan.planned_stripes);
  }
  if (scan.replayed) return "no verdict was recorded";
  return "no verdict: " + std::to_string(scan.good_stripes) + " good stripes of " +
         std::to_string(scan.planned_stripes);
}

void PrintText(const ReplayedLog& log, bool changed) {
  for (const auto& [id, scan] : log.scans) {
    std::cout << "scan " << id << ": ";
    if (scan.replayed) std::cout << VerdictText(*scan.replayed) << "  ";
    std::cout << Comparison(scan, changed) << "\n";
  }
}

void PrintJson(const ReplayedLog& log, const std::string& file,
               const std::string& calibration_hash) {
  using nlohmann::ordered_json;
  ordered_json scans = ordered_json::array();
  for (const auto& [id, scan] : log.scans) {
    ordered_json entry = {{"scan_id", id},
                          {"planned_stripes", scan.planned_stripes},
                          {"good_stripes", scan.good_stripes},
                          {"recorded", nullptr},
                          {"replayed", nullptr},
                          {"identical", scan.identical}};
    if (scan.recorded) {
      entry["recorded"] = ordered_json::parse(config::SerializeVerdict(*scan.recorded, file, 0));
    }
    if (scan.replayed) {
      entry["replayed"] = ordered_json::parse(config::SerializeVerdict(*scan.replayed, file, 0));
    }
    scans.push_back(entry);
  }
  const ordered_json root = {
      {"format", "geon.replay.v1"},
      {"log", file},
      {"events", log.events},
      {"whole", !log.damage.any() && log.unreadable == 0},
      {"damage", log.damage.any() ? messaging::Describe(log.damage) : ""},
      {"calibration", {{"recorded", log.recorded_calibration}, {"used", calibration_hash}}},
      {"identical", log.identical()},
      {"scans", scans}};
  std::cout << root.dump(-1, ' ', false, ordered_json::error_handler_t::replace) << "\n";
}

int Replay(const ReplayArguments& arguments) {
  auto config = recognizer::LoadRecognizerConfig(arguments.config_file, arguments.calibration);
  if (!config.ok()) {
    std::cerr << "geon replay: " << config.message() << "\n";
    return kUsage;
  }
  const auto calibration = recognizer::LoadCalibration(*config);
  if (!calibration.ok()) {
    std::cerr << "geon replay: " << calibration.message() << "\n";
    return kNotReady;
  }
  const std::string calibration_hash = recognizer::CalibrationHash(*config, *calibration);
  config->assembler.recognition = ToOptions(arguments.recognition, config->assembler.recognition);
  Progress progress("geon replay");
  const auto read = [&] {
    return ReplayLog(arguments.log, *config, *calibration,
                     [&progress](double done) { progress.Say(done); });
  };
  Result<ReplayedLog> log = read();
  const auto recorded = log.ok() ? RecordedMethod(*log) : std::nullopt;
  if (arguments.recognition.method.empty() && recorded &&
      *recorded != config->assembler.recognition.method) {
    config->assembler.recognition.method = *recorded;
    log = read();
  }
  if (!log.ok()) {
    std::cerr << "geon replay: " << log.message() << "\n";
    return kFailed;
  }
  for (const std::string& warning : Warnings(*log, calibration_hash)) {
    std::cerr << "geon replay: " << warning << "\n";
  }
  if (arguments.json) {
    PrintJson(*log, arguments.log, calibration_hash);
  } else {
    PrintText(*log, arguments.recognition.any());
  }
  if (log->scans.empty()) {
    std::cerr << "geon replay: " << arguments.log << " holds no scan\n";
    return kFailed;
  }
  return log->identical() || arguments.recognition.any() ? kOk : kFailed;
}

}  // namespace

void AddReplayCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command = app.add_subcommand(
      "replay", "Runs perception over a recorded log: the same verdicts as live.");
  command->add_option("LOG", arguments->log, "a log of lcm-logger")->required();
  command->add_option("--config", arguments->config_file, "robot file (rig and recognizer)");
  command->add_option("--calibration", arguments->calibration,
                      "folder of the look-up tables, instead of the robot file's");
  AddRecognitionArguments(*command, &arguments->recognition);
  command->add_flag("--json", arguments->json, "one JSON object (geon.replay.v1)");
  command->footer(
      "Exit 0 when every recorded verdict came out again bit for bit, or other options were asked\n"
      "for; 1 when one did not or the log holds no scan; 3 without a calibration.");
  command->callback([arguments, exit_code] { *exit_code = Replay(*arguments); });
}

}  // namespace geon::cli
