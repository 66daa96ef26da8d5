#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "config/daemon_arguments.h"
#include "config/rig_config.h"
#include "config/text_file.h"
#include "procs/geon/commands.h"
#include "procs/geon/report_page.h"
#include "procs/geon/verdict_text.h"

namespace geon::cli {
namespace {

struct ReportArguments {
  std::string log;
  std::string truth_file;
  std::string config_file = config::InstalledFile("scripts/config/robot.yaml").string();
  std::string output = "report.html";
  bool json = false;
};

Result<geometry::SensorRig> LoadRig(const std::string& robot_file) {
  Result<config::YamlDocument> document = config::LoadRobotFile(robot_file, {"rig"});
  if (!document.ok()) return document.status();
  const geometry::SensorRig rig =
      config::ReadRobotRig(document->root().Child("rig"), robot_file).rig;
  if (const Status status = document->Finish(); !status.ok()) return status;
  return rig;
}

int FailedToReport(const Status& status) {
  std::cerr << "geon report: " << status.message() << "\n";
  return kFailed;
}

std::string JsonLine(const ReportArguments& arguments, const RunRecord& run,
                     const std::optional<GeonLabel>& truth) {
  nlohmann::ordered_json line = {{"format", "geon.report.v1"},
                                 {"report", arguments.output},
                                 {"label", nullptr},
                                 {"truth", nullptr},
                                 {"seconds", run.duration_s},
                                 {"contacts", run.contacts},
                                 {"lost", run.channels.lost()},
                                 {"whole", !run.damage.any()}};
  if (run.verdict) line["label"] = std::string(ToString(run.verdict->label));
  if (truth) line["truth"] = std::string(ToString(*truth));
  return line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

int Report(const ReportArguments& arguments) {
  const auto rig = LoadRig(arguments.config_file);
  if (!rig.ok()) return FailedToReport(rig.status());
  std::optional<Truth> truth;
  if (!arguments.truth_file.empty()) {
    auto loaded = LoadTruth(arguments.truth_file);
    if (!loaded.ok()) return FailedToReport(loaded.status());
    truth = *loaded;
  }
  const auto run = ReadRun(arguments.log);
  if (!run.ok()) return FailedToReport(run.status());
  if (run->events == 0)
    return FailedToReport(Status::Error(arguments.log + ": holds no whole message"));
  const Status written =
      config::WriteFileAtomically(arguments.output, ReportPage(*run, *rig, truth));
  if (!written.ok()) return FailedToReport(written);

  const auto true_label = truth ? TrueLabel(*run, *truth) : std::nullopt;
  if (arguments.json) {
    std::cout << JsonLine(arguments, *run, true_label) << "\n";
  } else {
    std::cout << arguments.output << "\n";
  }
  return kOk;
}

}  // namespace

void AddReportCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand("report", "Writes one page that tells a recorded run.");
  command->add_option("LOG", arguments->log, "a log of lcm-logger")->required();
  command->add_option("--truth", arguments->truth_file,
                      "the simulator's truth file: compares the verdict, marks the real objects");
  command->add_option("--config", arguments->config_file, "robot file (rig)");
  command->add_option("-o,--output", arguments->output, "the page");
  command->add_flag("--json", arguments->json, "one JSON object (geon.report.v1)");
  command->callback([arguments, exit_code] { *exit_code = Report(*arguments); });
}

}  // namespace geon::cli
