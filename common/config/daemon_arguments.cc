#include "config/daemon_arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "config/text_file.h"
#include "geon_build.h"

namespace geon::config {

namespace {

constexpr std::array<const char*, 9> kRobotFileSections = {
    "bus", "rig",  "color_camera", "floor_camera", "stripe_camera",
    "ptu", "base", "planner",      "recognizer"};

constexpr int kExitUsage = 2;

}  // namespace

DaemonArguments::DaemonArguments(const std::string& program, const std::string& purpose,
                                 const std::string& examples)
    : config_file(InstalledFile("scripts/config/robot.yaml")),
      app_(std::make_unique<CLI::App>(purpose, program)),
      program_(program) {
  app_->set_version_flag("--version", program + " " + BuildVersion());
  app_->add_option("--config", config_file, "robot file; --check-config tells whether it is good")
      ->envname("GEON_CONFIG")
      ->capture_default_str();
  app_->add_flag("--check-config", check_config, "check the robot file and exit");
  app_->add_option("--lcm-url", lcm_url, "bus to use instead of the robot file's bus.url")
      ->envname("LCM_DEFAULT_URL");
  app_->footer("Examples:\n  " + examples +
               "\nExit codes: 0 ok, 1 failed, 2 usage or bad configuration, 3 not ready.");
}

DaemonArguments::~DaemonArguments() = default;

void DaemonArguments::AddOption(const std::string& name, std::string* value,
                                const std::string& help) {
  app_->add_option(name, *value, help);
}

void DaemonArguments::AddChoice(const std::string& name, std::string* value,
                                const std::vector<std::string>& choices, const std::string& help) {
  auto* option = app_->add_option(name, *value, help)->check(CLI::IsMember(choices));
  if (!value->empty()) option->capture_default_str();
}

void DaemonArguments::AddNumber(const std::string& name, std::optional<uint32_t>* value,
                                const std::string& help) {
  app_->add_option(name, *value, help);
}

void DaemonArguments::AddFlag(const std::string& name, bool* value, const std::string& help) {
  app_->add_flag(name, *value, help);
}

std::optional<int> DaemonArguments::Parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app_->exit(error) == 0 ? 0 : kExitUsage;
  }
  return std::nullopt;
}

int DaemonArguments::RefuseConfiguration(const Status& status) const {
  std::cerr << program_ << ": the configuration is refused:\n" << status.message() << '\n';
  return kExitUsage;
}

int DaemonArguments::AcceptConfiguration() const {
  std::cout << program_ << ": " << config_file.string() << " is good\n";
  return 0;
}

Result<YamlDocument> LoadRobotFile(const std::filesystem::path& file,
                                   const std::vector<std::string>& sections_read) {
  Result<YamlDocument> document = YamlDocument::Load(file);
  if (!document.ok()) return document;
  for (const char* section : kRobotFileSections) {
    const bool is_read =
        std::find(sections_read.begin(), sections_read.end(), section) != sections_read.end();
    if (!is_read) document->root().Ignore(section);
  }
  return document;
}

std::string FileHash(const std::filesystem::path& file) {
  const Result<std::string> bytes = ReadFile(file);
  return ContentHash(bytes.ok() ? *bytes : "");
}

std::filesystem::path InstalledFile(const std::string& relative) {
  return std::filesystem::path(GEON_SOURCE_TREE) / relative;
}

std::string BuildVersion() { return GEON_BUILD_VERSION; }

}  // namespace geon::config
