#include <unistd.h>

#include <chrono>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "config/verdict_json.h"
#include "procs/geon/commands.h"
#include "procs/geon/group_status.h"
#include "procs/geon/mission_watch.h"

namespace geon::cli {

namespace {

struct WatchArguments {
  double timeout_s = 900.0;
  bool json = false;
};

// One line that is overwritten on a terminal, one line a change elsewhere.
class ProgressLine {
 public:
  void Show(const sensor::PlannerState& state) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    std::ostringstream line;
    line << std::fixed << std::setprecision(0) << std::setw(4) << elapsed.count() << " s  "
         << std::left << std::setw(10) << state.phase << ' ' << state.text;
    if (on_terminal_) {
      std::cerr << "\r\x1b[K" << line.str() << std::flush;
    } else {
      std::cerr << line.str() << '\n';
    }
  }
  void Close() const {
    if (on_terminal_) std::cerr << '\n';
  }

 private:
  const bool on_terminal_ = isatty(STDERR_FILENO) != 0;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string OutcomeName(const MissionWatch& watch, bool ended) {
  if (!watch.state()) return "silent";
  if (!ended) return "timeout";
  return std::string(ToString(watch.state()->outcome));
}

// Of one geon that the mission has finished with; places as in PLANNER_STATE.
nlohmann::ordered_json FindingJson(const sensor::GeonFinding& finding) {
  nlohmann::ordered_json posterior;
  for (size_t k = 0; k < kGeonLabelCount; ++k) {
    posterior[std::string(kGeonLabelNames[k])] = finding.posterior[k];
  }
  return {{"label", finding.label ? nlohmann::ordered_json(ToString(*finding.label))
                                  : nlohmann::ordered_json()},
          {"confidence", finding.confidence},
          {"decided", finding.decided},
          {"posterior", posterior},
          {"place_m", {finding.p_W_m.x(), finding.p_W_m.y()}},
          {"support_height_m", finding.support_height_m},
          {"views", finding.views},
          {"why", finding.why}};
}

void PrintJson(const MissionWatch& watch, const std::string& outcome) {
  nlohmann::ordered_json whole = {{"format", "geon.outcome.v1"},
                                  {"outcome", outcome},
                                  {"phase", nullptr},
                                  {"text", nullptr},
                                  {"target_m", nullptr},
                                  {"verdict", nullptr},
                                  {"findings", nlohmann::ordered_json::array()}};
  if (watch.state()) {
    whole["phase"] = watch.state()->phase;
    whole["text"] = watch.state()->text;
    const auto& target = watch.state()->p_WTarget_m;
    if (target) whole["target_m"] = {target->x(), target->y()};
    for (const sensor::GeonFinding& finding : watch.state()->findings) {
      whole["findings"].push_back(FindingJson(finding));
    }
  }
  if (watch.verdict()) {
    whole["verdict"] =
        nlohmann::ordered_json::parse(config::SerializeVerdict(*watch.verdict(), "", 0));
  }
  std::cout << whole.dump() << '\n';
}

void PrintText(const MissionWatch& watch, const std::string& outcome) {
  std::cout << "outcome: " << outcome;
  if (watch.state())
    std::cout << " (" << watch.state()->phase << ": " << watch.state()->text << ")";
  std::cout << '\n';
  if (!watch.verdict()) return;
  const sensor::GeonVerdict& verdict = *watch.verdict();
  std::cout << "verdict: " << ToString(verdict.label) << ", confidence " << std::fixed
            << std::setprecision(2) << verdict.confidence << ", method " << verdict.method << '\n';
  for (const std::string& reason : verdict.reasons) std::cout << "  " << reason << '\n';
}

int Watch(const WatchArguments& arguments) {
  const Result<std::string> url = BusUrlOfRun();
  if (!url.ok()) {
    std::cerr << "geon watch: " << url.message() << '\n';
    return kUsage;
  }
  ProgressLine line;
  Result<std::unique_ptr<MissionWatch>> watch =
      MissionWatch::Open(*url, [&line](const sensor::PlannerState& state) { line.Show(state); });
  if (!watch.ok()) {
    std::cerr << "geon watch: " << watch.message() << '\n';
    return kFailed;
  }
  const bool ended = (*watch)->Await(arguments.timeout_s);
  line.Close();
  const std::string outcome = OutcomeName(**watch, ended);
  if (arguments.json) {
    PrintJson(**watch, outcome);
  } else {
    PrintText(**watch, outcome);
  }
  if (!ended) return kNotReady;
  return outcome == "named" ? kOk : kFailed;
}

}  // namespace

void AddWatchCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<WatchArguments>();
  CLI::App* command = app.add_subcommand("watch", "follow the mission until it ends");
  command->add_option("--timeout-s", arguments->timeout_s, "how long at most")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "outcome and verdict as one JSON object");
  command->footer(
      "Examples:\n  geon watch\n  geon watch --json --timeout-s 300\n"
      "Exit code 0: a geon was named; 1: the mission failed; 3: it did not end in time.");
  command->callback([arguments, exit_code] { *exit_code = Watch(*arguments); });
}

}  // namespace geon::cli
