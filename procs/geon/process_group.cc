#include "procs/geon/process_group.h"

#include <cstdlib>
#include <fstream>

#include "config/daemon_arguments.h"

namespace geon::cli {

namespace {

std::string FromEnvironment(const std::string& name, const std::string& otherwise) {
  const char* value = std::getenv(name.c_str());
  return value != nullptr && *value != '\0' ? value : otherwise;
}

// "geon-ptu" of: command="%(ENV_GEON_BIN_DIR)s/geon-ptu" --port ...
std::string ProgramOfCommand(const std::string& line) {
  const std::string marker = "GEON_BIN_DIR)s/";
  const size_t begin = line.find(marker);
  if (begin == std::string::npos) return "";
  const size_t name = begin + marker.size();
  return line.substr(name, line.find_first_of("\" ", name) - name);
}

}  // namespace

const std::vector<std::string>& ProcessGroupNames() {
  static const std::vector<std::string> kNames = {"sim", "robot", "workstation"};
  return kNames;
}

Result<ProcessGroup> LoadProcessGroup(const std::string& name) {
  ProcessGroup group;
  group.name = name;
  group.conf = config::InstalledFile("scripts/supervisor/" + name + ".conf");
  std::ifstream file(group.conf);
  if (!file) return Status::Error(group.conf.string() + ": cannot be read; there is no such group");
  const std::string section = "[program:";
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(section)) {
      group.processes.push_back(line.substr(section.size(), line.find(']') - section.size()));
    } else if (line.starts_with("command=")) {
      group.programs.push_back(ProgramOfCommand(line));
    }
  }
  if (group.processes.empty() || group.programs.size() != group.processes.size()) {
    return Status::Error(group.conf.string() + ": every [program:...] needs one command=");
  }
  return group;
}

std::filesystem::path RunDirectory() {
  return std::filesystem::absolute(
             FromEnvironment("GEON_RUN_DIR", config::InstalledFile("run").string()))
      .lexically_normal();
}

std::filesystem::path BinDirectory() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

Result<Environment> ReadEnvironmentFile(const std::filesystem::path& file,
                                        const std::filesystem::path& run_directory) {
  std::ifstream stream(file);
  if (!stream) return Status::Error(file.string() + ": cannot be read");
  const std::string placeholder = "${GEON_RUN_DIR}";
  Environment environment;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const size_t equals = line.find('=');
    if (equals == std::string::npos || equals == 0) {
      return Status::Error(file.string() + ":" + std::to_string(number) + ": not KEY=VALUE");
    }
    std::string value = line.substr(equals + 1);
    for (size_t at = value.find(placeholder); at != std::string::npos;
         at = value.find(placeholder)) {
      value.replace(at, placeholder.size(), run_directory.string());
    }
    environment[line.substr(0, equals)] = value;
  }
  return environment;
}

Result<Environment> GroupEnvironment(const UpOptions& options) {
  Result<Environment> environment = ReadEnvironmentFile(
      config::InstalledFile("scripts/supervisor/simulated_devices.env"), RunDirectory());
  if (!environment.ok()) return environment;
  for (auto& [name, flags] : *environment) {
    flags = FromEnvironment(name, options.simulated_devices ? flags : "");
  }
  (*environment)["GEON_RUN_DIR"] = RunDirectory().string();
  (*environment)["GEON_BIN_DIR"] = BinDirectory().string();
  (*environment)["GEON_WORLD"] = options.world.string();
  (*environment)["GEON_SEED"] = std::to_string(options.seed);
  if (!options.lcm_url.empty()) (*environment)["LCM_DEFAULT_URL"] = options.lcm_url;
  return environment;
}

}  // namespace geon::cli
