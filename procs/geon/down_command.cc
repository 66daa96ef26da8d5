#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "procs/geon/commands.h"
#include "procs/geon/supervisor.h"

namespace geon::cli {

namespace {

struct DownArguments {
  std::vector<std::string> groups;
  bool json = false;
};

// Last started, first stopped: the simulated devices are there to take the last orders (lasers
// off).
int Down(const DownArguments& arguments) {
  int exit_code = kOk;
  nlohmann::ordered_json stopped = nlohmann::ordered_json::array();
  const std::vector<std::string>& names = ProcessGroupNames();
  for (auto name = names.rbegin(); name != names.rend(); ++name) {
    const bool asked = std::find(arguments.groups.begin(), arguments.groups.end(), *name) !=
                       arguments.groups.end();
    if (!asked && !arguments.groups.empty()) continue;
    Result<ProcessGroup> group = LoadProcessGroup(*name);
    const Supervisor supervisor(group.ok() ? *group : ProcessGroup{*name, "", {}, {}}, {});
    if (!supervisor.IsUp()) continue;
    const Status status = supervisor.Stop();
    if (status.ok()) {
      stopped.push_back(*name);
    } else {
      std::cerr << "geon down: " << status.message() << '\n';
      exit_code = kFailed;
    }
  }
  if (arguments.json) {
    std::cout << nlohmann::ordered_json{{"format", "geon.down.v1"}, {"stopped", stopped}}.dump()
              << '\n';
  } else {
    for (const auto& name : stopped) std::cout << name.get<std::string>() << " is down\n";
    if (stopped.empty() && exit_code == kOk) std::cout << "nothing was up\n";
  }
  return exit_code;
}

}  // namespace

void AddDownCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<DownArguments>();
  CLI::App* command = app.add_subcommand("down", "stop process groups");
  command->add_option("group", arguments->groups, "sim, robot, workstation; default all")
      ->check(CLI::IsMember(ProcessGroupNames()));
  command->add_flag("--json", arguments->json, "one JSON object");
  command->footer("Examples:\n  geon down\n  geon down workstation");
  command->callback([arguments, exit_code] { *exit_code = Down(*arguments); });
}

}  // namespace geon::cli
