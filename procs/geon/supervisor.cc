#include "procs/geon/supervisor.h"

#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

namespace geon::cli {

namespace {

constexpr size_t kLongestSocketPath = 107;  // sun_path
constexpr double kStopTimeout_s = 20.0;

std::string ReadText(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

Supervisor::Supervisor(ProcessGroup group, Environment environment)
    : group_(std::move(group)), environment_(std::move(environment)) {}

std::filesystem::path Supervisor::FileInRun(const std::string& folder,
                                            const std::string& name) const {
  return RunDirectory() / folder / name;
}

// A pid file may outlive its process, and the number may be another's by now.
std::optional<int> Supervisor::Pid() const {
  const int pid = std::atoi(ReadText(FileInRun("supervisor", group_.name + ".pid")).c_str());
  if (pid <= 0) return std::nullopt;
  const std::string words = ReadText("/proc/" + std::to_string(pid) + "/cmdline");
  const bool is_ours = words.find(group_.conf.string()) != std::string::npos;
  return is_ours ? std::optional<int>(pid) : std::nullopt;
}

bool Supervisor::IsUp() const { return Pid().has_value(); }

Status Supervisor::CheckConfigurations() const {
  for (const std::string& program : group_.programs) {
    std::vector<std::string> words = {(BinDirectory() / program).string(), "--check-config"};
    if (program == "geon-sim") {
      words.insert(words.end(), {"--world", environment_.at("GEON_WORLD")});
    }
    const Result<ProgramOutcome> check = RunProgram(words, environment_);
    if (!check.ok()) return check.status().In(program);
    if (check->exit_code != 0) return Status::Error(check->output);
  }
  return Status::Ok();
}

Status Supervisor::Start() const {
  const std::string socket = FileInRun("supervisor", group_.name + ".sock").string();
  if (socket.size() > kLongestSocketPath) {
    return Status::Error(socket + ": too long for a socket; choose a shorter GEON_RUN_DIR");
  }
  const Status good = CheckConfigurations();
  if (!good.ok()) return good;
  for (const char* folder : {"supervisor", "log"}) {
    std::filesystem::create_directories(RunDirectory() / folder);
  }
  // Restarts are counted in this log: from this start on.
  std::filesystem::remove(FileInRun("log", "supervisor-" + group_.name + ".log"));
  const Result<ProgramOutcome> start =
      RunProgram({"supervisord", "-c", group_.conf.string()}, environment_);
  if (!start.ok()) return start.status().In("supervisord (scripts/setup installs it)");
  if (start->exit_code != 0) return Status::Error("supervisord: " + start->output);
  return Status::Ok();
}

Status Supervisor::Stop() const {
  const std::optional<int> pid = Pid();
  if (!pid) return Status::Ok();
  kill(*pid, SIGTERM);
  for (double waited_s = 0.0; waited_s < kStopTimeout_s; waited_s += 0.05) {
    if (!IsUp()) return Status::Ok();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return Status::Error(group_.name + ": still running after " +
                       std::to_string(static_cast<int>(kStopTimeout_s)) + " s (supervisord, pid " +
                       std::to_string(*pid) + ")");
}

Result<ProgramOutcome> Supervisor::Control(const std::string& word) const {
  return RunProgram({"supervisorctl", "-c", group_.conf.string(), word}, environment_);
}

std::vector<ProcessState> Supervisor::States() const {
  std::vector<ProcessState> states;
  if (IsUp()) {
    const Result<ProgramOutcome> answer = Control("status");
    if (answer.ok()) states = ParseStates(answer->output, group_.name);
    const std::string log = ReadText(FileInRun("log", "supervisor-" + group_.name + ".log"));
    for (ProcessState& state : states) state.restarts = CountRestarts(log, state.name);
  }
  if (states.empty()) {
    for (const std::string& process : group_.processes) {
      states.push_back({process, group_.name, "DOWN", "geon up " + group_.name + " starts it"});
    }
  }
  return states;
}

std::vector<ProcessState> ParseStates(const std::string& text, const std::string& group) {
  std::vector<ProcessState> states;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    ProcessState state;
    state.group = group;
    if (!(words >> state.name >> state.state) || !state.name.starts_with("geon-")) continue;
    std::getline(words >> std::ws, state.detail);
    if (state.detail.starts_with("pid ")) state.pid = std::atoi(state.detail.c_str() + 4);
    states.push_back(state);
  }
  return states;
}

int CountRestarts(const std::string& log, const std::string& process) {
  const std::string spawned = "spawned: '" + process + "' ";
  int count = 0;
  for (size_t at = log.find(spawned); at != std::string::npos; at = log.find(spawned, at + 1)) {
    ++count;
  }
  return count > 0 ? count - 1 : 0;
}

}  // namespace geon::cli
