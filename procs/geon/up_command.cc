#include <chrono>
#include <iostream>
#include <memory>

#include "config/daemon_arguments.h"
#include "procs/geon/commands.h"
#include "procs/geon/group_status.h"

namespace geon::cli {

namespace {

struct UpArguments {
  std::vector<std::string> groups;
  UpOptions options;
  double timeout_s = 30.0;
  bool json = false;
};

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The groups to start, in order. A simulated world brings the robot group along, wired to it.
std::vector<std::string> GroupsToStart(const std::vector<std::string>& asked) {
  std::vector<std::string> groups;
  for (const std::string& name : ProcessGroupNames()) {
    const bool comes_along = name == "robot" && Contains(asked, "sim");
    if (asked.empty() || Contains(asked, name) || comes_along) groups.push_back(name);
  }
  return groups;
}

std::string NamesOfUnready(const std::vector<ProcessStatus>& statuses) {
  std::string names;
  for (const ProcessStatus& status : statuses) {
    if (!status.ready()) names += " " + status.state.name;
  }
  return names;
}

// Until every process is ready, one gives up, or the time is over.
std::vector<ProcessStatus> AwaitReadiness(const std::vector<Supervisor>& supervisors,
                                          HealthWatch& watch, double timeout_s) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(timeout_s);
  std::string told;
  for (;;) {
    watch.Listen(0.5);
    std::vector<ProcessStatus> statuses = CollectStatus(supervisors, watch);
    const std::string unready = NamesOfUnready(statuses);
    bool hopeless = false;
    for (const ProcessStatus& status : statuses) {
      const std::string& state = status.state.state;
      hopeless |= state == "FATAL" || state == "EXITED" || state == "DOWN";
    }
    if (unready.empty() || hopeless || Clock::now() > end) return statuses;
    if (unready != told) std::cerr << "waiting for" << unready << '\n';
    told = unready;
  }
}

Status StartGroups(const UpArguments& arguments, const Environment& environment,
                   std::vector<Supervisor>* supervisors) {
  for (const std::string& name : GroupsToStart(arguments.groups)) {
    Result<ProcessGroup> group = LoadProcessGroup(name);
    if (!group.ok()) return group.status();
    supervisors->emplace_back(*std::move(group), environment);
    if (supervisors->back().IsUp()) {
      std::cerr << name << " is already up\n";
      continue;
    }
    const Status started = supervisors->back().Start();
    if (!started.ok()) return started;
  }
  return Status::Ok();
}

int Up(UpArguments arguments) {
  const std::vector<std::string> groups = GroupsToStart(arguments.groups);
  arguments.options.simulated_devices = Contains(groups, "sim");
  const Result<std::string> url = BusUrlOfRun();
  if (!url.ok()) {
    std::cerr << "geon up: " << url.message() << '\n';
    return kUsage;
  }
  arguments.options.lcm_url = *url;
  const Result<Environment> environment = GroupEnvironment(arguments.options);
  if (!environment.ok()) {
    std::cerr << "geon up: " << environment.message() << '\n';
    return kFailed;
  }
  Result<std::unique_ptr<HealthWatch>> watch = HealthWatch::Open(*url);
  if (!watch.ok()) {
    std::cerr << "geon up: " << watch.message() << '\n';
    return kFailed;
  }
  std::vector<Supervisor> supervisors;
  Status status = RememberBusUrl(*url);
  if (status.ok()) status = StartGroups(arguments, *environment, &supervisors);
  if (!status.ok()) {
    std::cerr << "geon up: " << status.message() << '\n';
    return kUsage;
  }
  const std::vector<ProcessStatus> statuses =
      AwaitReadiness(supervisors, **watch, arguments.timeout_s);
  std::cout << (arguments.json ? StatusJson(statuses) : StatusTable(statuses));
  const std::string unready = NamesOfUnready(statuses);
  if (unready.empty()) return kOk;
  std::cerr << "geon up: not ready:" << unready << "; logs are in "
            << (RunDirectory() / "log").string() << '\n';
  return kNotReady;
}

}  // namespace

void AddUpCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<UpArguments>();
  arguments->options.world = config::InstalledFile("scripts/config/worlds/demo.yaml");
  CLI::App* command = app.add_subcommand("up", "start process groups and wait until they work");
  command
      ->add_option("group", arguments->groups,
                   "sim (with the robot wired to it), robot, workstation; default all")
      ->check(CLI::IsMember(ProcessGroupNames()));
  command->add_option("--world", arguments->options.world, "world file of the simulator")
      ->check(CLI::ExistingFile)
      ->capture_default_str();
  command->add_option("--seed", arguments->options.seed, "of the simulator's noise")
      ->capture_default_str();
  command->add_option("--timeout-s", arguments->timeout_s, "how long to wait")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "one JSON object (geon.status.v1)");
  command->footer(
      "Examples:\n  geon up sim workstation --world scripts/config/worlds/demo.yaml\n"
      "  geon up robot            # on the robot\n  geon up workstation      # on the workstation\n"
      "Groups are data: scripts/supervisor/*.conf. GEON_RUN_DIR chooses another run directory, "
      "LCM_DEFAULT_URL another bus.");
  command->callback([arguments, exit_code] { *exit_code = Up(*arguments); });
}

}  // namespace geon::cli
