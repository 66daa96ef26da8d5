#include "procs/geon/group_status.h"

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "config/bus_config.h"
#include "config/text_file.h"

namespace geon::cli {

namespace {

std::filesystem::path BusUrlFile() { return RunDirectory() / "supervisor" / "bus_url"; }

std::string WithoutNewline(std::string text) {
  text.erase(std::find(text.begin(), text.end(), '\n'), text.end());
  return text;
}

}  // namespace

bool ProcessStatus::ready() const {
  if (state.state != "RUNNING") return false;
  return !speaks || (heard && (health == "ok" || health == "warn"));
}

std::vector<ProcessStatus> CollectStatus(const std::vector<Supervisor>& supervisors,
                                         const HealthWatch& watch) {
  std::vector<ProcessStatus> statuses;
  for (const Supervisor& supervisor : supervisors) {
    for (const ProcessState& state : supervisor.States()) {
      ProcessStatus status;
      status.state = state;
      status.speaks = supervisor.group().name != "sim";
      const HealthWatch::Heard* heard = watch.Of(state.name);
      status.heard = heard != nullptr && heard->health.pid == state.pid;
      status.health =
          status.heard ? ToString(heard->health.level) : (status.speaks ? "silent" : "-");
      if (status.heard) {
        status.text = heard->health.text;
        status.rx_lost = heard->health.rx_lost;
        status.age_s = HealthWatch::AgeInSeconds(*heard);
      }
      statuses.push_back(status);
    }
  }
  return statuses;
}

std::string StatusTable(const std::vector<ProcessStatus>& statuses) {
  std::ostringstream table;
  table << std::left << std::setw(13) << "group" << std::setw(26) << "process" << std::setw(10)
        << "state" << std::setw(10) << "health" << std::setw(8) << "age" << std::setw(10)
        << "restarts"
        << "more\n";
  for (const ProcessStatus& status : statuses) {
    std::ostringstream age;
    if (status.heard) age << std::fixed << std::setprecision(1) << status.age_s << " s";
    table << std::setw(13) << status.state.group << std::setw(26) << status.state.name
          << std::setw(10) << status.state.state << std::setw(10) << status.health << std::setw(8)
          << age.str() << std::setw(10) << status.state.restarts
          << (status.text.empty() ? status.state.detail : status.text) << '\n';
  }
  return table.str();
}

std::string StatusJson(const std::vector<ProcessStatus>& statuses) {
  nlohmann::ordered_json processes = nlohmann::ordered_json::array();
  for (const ProcessStatus& status : statuses) {
    nlohmann::ordered_json process = {{"group", status.state.group},
                                      {"process", status.state.name},
                                      {"state", status.state.state},
                                      {"pid", nullptr},
                                      {"restarts", status.state.restarts},
                                      {"health", status.health},
                                      {"age_s", nullptr},
                                      {"rx_lost", nullptr},
                                      {"text", status.text},
                                      {"ready", status.ready()}};
    if (status.state.pid > 0) process["pid"] = status.state.pid;
    if (status.heard) {
      process["age_s"] = status.age_s;
      process["rx_lost"] = status.rx_lost;
    }
    processes.push_back(process);
  }
  const nlohmann::ordered_json whole = {{"format", "geon.status.v1"},
                                        {"run_directory", RunDirectory().string()},
                                        {"processes", processes}};
  return whole.dump() + "\n";
}

Result<std::string> BusUrlOfRun() {
  const char* from_environment = std::getenv("LCM_DEFAULT_URL");
  if (from_environment != nullptr && *from_environment != '\0') {
    return std::string(from_environment);
  }
  const Result<std::string> remembered = config::ReadFile(BusUrlFile());
  if (remembered.ok()) return WithoutNewline(*remembered);
  const config::DaemonArguments defaults("geon", "", "");
  const char* file = std::getenv("GEON_CONFIG");
  Result<config::YamlDocument> robot_file =
      config::LoadRobotFile(file != nullptr ? file : defaults.config_file, {"bus"});
  if (!robot_file.ok()) return robot_file.status();
  const std::string url = config::ReadBusUrl(defaults, robot_file->root().Child("bus"));
  const Status good = robot_file->Finish();
  if (!good.ok()) return good;
  return url;
}

Status RememberBusUrl(const std::string& url) {
  std::filesystem::create_directories(BusUrlFile().parent_path());
  return config::WriteFileAtomically(BusUrlFile(), url + "\n");
}

}  // namespace geon::cli
