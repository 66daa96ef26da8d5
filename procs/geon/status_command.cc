#include <iostream>
#include <memory>

#include "procs/geon/commands.h"
#include "procs/geon/group_status.h"

namespace geon::cli {

namespace {

// Health comes once a second; a little more than that hears everyone who speaks.
constexpr double kListen_s = 1.3;

struct StatusArguments {
  std::vector<std::string> groups;
  bool json = false;
};

int ShowStatus(const StatusArguments& arguments) {
  const Result<std::string> url = BusUrlOfRun();
  if (!url.ok()) {
    std::cerr << "geon status: " << url.message() << '\n';
    return kUsage;
  }
  Result<std::unique_ptr<HealthWatch>> watch = HealthWatch::Open(*url);
  if (!watch.ok()) {
    std::cerr << "geon status: " << watch.message() << '\n';
    return kFailed;
  }
  const Result<Environment> environment = GroupEnvironment({});
  std::vector<Supervisor> supervisors;
  for (const std::string& name :
       arguments.groups.empty() ? ProcessGroupNames() : arguments.groups) {
    Result<ProcessGroup> group = LoadProcessGroup(name);
    if (!group.ok() || !environment.ok()) {
      std::cerr << "geon status: " << group.message() << environment.message() << '\n';
      return kFailed;
    }
    supervisors.emplace_back(*std::move(group), *environment);
  }
  (*watch)->Listen(kListen_s);
  const std::vector<ProcessStatus> statuses = CollectStatus(supervisors, **watch);
  std::cout << (arguments.json ? StatusJson(statuses) : StatusTable(statuses));
  for (const ProcessStatus& status : statuses) {
    const bool expected = !arguments.groups.empty() || status.state.state != "DOWN";
    if (expected && !status.ready()) return kNotReady;
  }
  return kOk;
}

}  // namespace

void AddStatusCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<StatusArguments>();
  CLI::App* command =
      app.add_subcommand("status", "what runs, how it feels, how often it was restarted");
  command->add_option("group", arguments->groups, "sim, robot, workstation; default all")
      ->check(CLI::IsMember(ProcessGroupNames()));
  command->add_flag("--json", arguments->json, "one JSON object (geon.status.v1)");
  command->footer(
      "Exit code 0: every process of the groups asked for (default: of those that are up) is "
      "ready; 3: not.");
  command->callback([arguments, exit_code] { *exit_code = ShowStatus(*arguments); });
}

}  // namespace geon::cli
