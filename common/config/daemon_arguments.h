#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "config/yaml_section.h"

namespace CLI {
class App;
}

namespace geon::config {

// The command line every daemon shares: --config, --check-config, --lcm-url, --version, --help.
//
//   DaemonArguments arguments("geon-ptu", "Drives the pan-tilt unit.", "geon-ptu --port /dev/x");
//   arguments.AddOption("--port", &port, "...");
//   if (auto exit_code = arguments.Parse(argc, argv)) return *exit_code;
//
// Exit codes: 0 ok, 1 failed, 2 usage or bad configuration, 3 not ready.
class DaemonArguments {
 public:
  DaemonArguments(const std::string& program, const std::string& purpose,
                  const std::string& examples);
  ~DaemonArguments();

  // Options of one daemon only. Values outlive Parse() and keep what they hold where nothing is
  // said.
  void AddOption(const std::string& name, std::string* value, const std::string& help);
  void AddChoice(const std::string& name, std::string* value,
                 const std::vector<std::string>& choices, const std::string& help);
  void AddNumber(const std::string& name, std::optional<uint32_t>* value, const std::string& help);
  void AddFlag(const std::string& name, bool* value, const std::string& help);

  // Nothing to do but go on, or the exit code (help and version print and exit 0; usage errors 2).
  std::optional<int> Parse(int argc, char** argv);

  // Says on stderr why the configuration is refused; returns exit code 2.
  int RefuseConfiguration(const Status& status) const;
  // For --check-config: says that the file is good; returns 0.
  int AcceptConfiguration() const;

  std::filesystem::path config_file;  // --config, else $GEON_CONFIG, else the installed robot.yaml
  bool check_config = false;
  std::string lcm_url;  // --lcm-url, else $LCM_DEFAULT_URL, else empty: bus.url of the file

 private:
  std::unique_ptr<CLI::App> app_;
  std::string program_;
};

// Opens the shared robot file for the reader of some of its sections: every other known section is
// left to its owner, unknown ones are errors.
Result<YamlDocument> LoadRobotFile(const std::filesystem::path& file,
                                   const std::vector<std::string>& sections_read);

// FNV-1a of the file's bytes, 16 hex digits: names a configuration in health and session messages.
std::string FileHash(const std::filesystem::path& file);

// A file that comes with the programs, by its path in the source tree: "scripts/config/robot.yaml".
std::filesystem::path InstalledFile(const std::string& relative);

// `git describe` of the build.
std::string BuildVersion();

}  // namespace geon::config
