#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <mutex>

#include "config/daemon_arguments.h"
#include "config/text_file.h"
#include "procs/geon/barn_courses.h"
#include "procs/geon/commands.h"
#include "procs/geon/experiment_commands.h"
#include "procs/geon/navigation_record.h"
#include "procs/geon/parallel_for.h"
#include "procs/geon/progress.h"
#include "sim/random_pen.h"
#include "sim/world_file.h"

namespace geon::cli {
namespace {

using lockstep::NavigationEnd;

struct NavigationArguments {
  std::vector<std::filesystem::path> worlds;
  std::filesystem::path barn, output, robot_file, sim_file;
  int pens = 200;
  std::string pen = "mixed";
  std::string planner;  // the robot file's
  std::string sensors = "real";
  std::string shard = "1/1";
  uint64_t seed = 1;
  std::optional<double> longest_s;
  bool json = false;
  int jobs = 1;
};

double Longest_s(const NavigationArguments& arguments) {
  constexpr double kPen_s = 120.0, kCourse_s = 240.0;
  return arguments.longest_s.value_or(arguments.barn.empty() ? kPen_s : kCourse_s);
}

int FailNavigation(const Status& status) {
  std::cerr << "geon experiment navigation: " << status.message() << '\n';
  return kFailed;
}

// A run to be made.
struct NavigationCase {
  NavigationTrialRecord trial;
  std::optional<sim::World> world;  // else a pen, made when its turn comes
  sim::PenKind pen = sim::PenKind::kBoxes;
  std::optional<Eigen::Vector2d> destination_W_m;
};

std::vector<NavigationCase> PenCases(const NavigationArguments& arguments) {
  std::vector<NavigationCase> cases;
  for (int t = 0; t < arguments.pens; ++t) {
    NavigationCase each;
    each.trial.t = t;
    each.trial.seed = arguments.seed + static_cast<uint64_t>(t);
    each.pen = sim::PenKindFromString(arguments.pen).value_or(sim::MixedPenKind(each.trial.seed));
    each.trial.world = ToString(each.pen);
    if (each.pen == sim::PenKind::kUnreachable) each.trial.expected = NavigationEnd::kUnreachable;
    if (each.pen == sim::PenKind::kEmpty) each.trial.expected = NavigationEnd::kNoneFound;
    cases.push_back(each);
  }
  return cases;
}

Result<std::vector<NavigationCase>> WorldCases(const NavigationArguments& arguments) {
  std::vector<NavigationCase> cases;
  for (const std::filesystem::path& file : arguments.worlds) {
    Result<sim::World> world = sim::LoadWorld(file);
    if (!world.ok()) return world.status();
    NavigationCase each;
    if (std::none_of(world->objects.begin(), world->objects.end(), sim::IsTarget)) {
      each.trial.expected = NavigationEnd::kNoneFound;
    }
    each.trial.t = static_cast<int>(cases.size());
    each.trial.seed = arguments.seed + cases.size();
    each.trial.world = file.filename().string();
    each.world = std::move(*world);
    cases.push_back(std::move(each));
  }
  return cases;
}

Result<std::vector<NavigationCase>> BarnCases(const NavigationArguments& arguments) {
  Result<std::vector<BarnCourse>> courses = LoadBarnCourses(arguments.barn);
  if (!courses.ok()) return courses.status();
  std::vector<NavigationCase> cases;
  for (BarnCourse& course : *courses) {
    NavigationCase each;
    each.trial.t = static_cast<int>(cases.size());
    each.trial.seed = arguments.seed + cases.size();
    each.trial.world = course.split;
    each.trial.course = CourseRecord{course.id, course.shortest_m, course.optimal_s, 0.0};
    each.world = std::move(course.world);
    each.destination_W_m = course.destination_W_m;
    cases.push_back(std::move(each));
  }
  return cases;
}

Result<std::vector<NavigationCase>> CasesOf(const NavigationArguments& arguments) {
  if (!arguments.barn.empty()) return BarnCases(arguments);
  if (!arguments.worlds.empty()) return WorldCases(arguments);
  return PenCases(arguments);
}

Status RunCases(const lockstep::LockstepSettings& settings, const NavigationArguments& arguments,
                std::vector<NavigationCase>* cases, NavigationRecord* record) {
  Progress progress("geon experiment navigation");
  Status failed = Status::Ok();
  std::mutex mutex;
  size_t done = 0;
  ParallelFor(arguments.jobs, static_cast<int>(cases->size()), [&](int k) {
    NavigationCase& each = (*cases)[static_cast<size_t>(k)];
    NavigationTrialRecord& trial = each.trial;
    const sim::World world = each.world ? *each.world : sim::RandomPen(trial.seed, each.pen);
    lockstep::LockstepSettings own = settings;
    own.mission.destination_W_m = each.destination_W_m;
    const auto outcome = lockstep::RunNavigationTrial(own, world, trial.seed, Longest_s(arguments));
    const std::lock_guard lock(mutex);
    progress.Say(static_cast<double>(++done) / static_cast<double>(cases->size()));
    if (!outcome.ok()) {
      failed = outcome.status();
      return;
    }
    trial.end = outcome->end;
    trial.why = outcome->why;
    trial.end_s = outcome->end_s;
    const lockstep::RunTrack& track = outcome->track;
    trial.first_sight_s = track.first_sight_s;
    trial.contacts = track.contacts;
    trial.hardest_contact_m_s = track.hardest_contact_m_s;
    trial.path_m = track.path_m;
    if (trial.course) trial.course->left_m = outcome->left_m.value_or(0.0);
    if (!trial.right() || trial.contacts > 0) {
      AddDrawnRun(DrawRun(trial.t, world, track.path_W_m), &record->maps);
    }
  });
  for (const NavigationCase& each : *cases) record->trials.push_back(each.trial);
  return failed;
}

int RunNavigation(const NavigationArguments& arguments) {
  Result<lockstep::LockstepSettings> loaded =
      lockstep::LoadLockstepSettings(arguments.robot_file, arguments.sim_file);
  if (!loaded.ok()) return FailNavigation(loaded.status());
  const auto quality = *lockstep::SensorQualityFromString(arguments.sensors);
  lockstep::LockstepSettings settings = lockstep::ForNavigation(*std::move(loaded), quality);
  mission::PlannerKind& planner = settings.mission.driving.planner;
  planner = mission::PlannerKindFromString(arguments.planner).value_or(planner);

  Result<std::vector<NavigationCase>> cases = CasesOf(arguments);
  if (!cases.ok()) return FailNavigation(cases.status());
  const Shard shard = ParseShard(arguments.shard);
  std::erase_if(*cases, [&](const NavigationCase& each) {
    return each.trial.t % shard.count != shard.index - 1;
  });
  const bool pens = arguments.worlds.empty() && arguments.barn.empty();
  NavigationRecord record;
  record.planner = ToString(planner);
  record.seed = arguments.seed;
  record.git = config::BuildVersion();
  record.conditions = {{"sensors", arguments.sensors},
                       {"pens", pens ? arguments.pens : 0},
                       {"pen", pens ? arguments.pen : ""},
                       {"longest_s", Longest_s(arguments)}};
  const auto begin = std::chrono::steady_clock::now();
  if (Status status = RunCases(settings, arguments, &*cases, &record); !status.ok()) {
    return FailNavigation(status);
  }
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  double virtual_s = 0.0;
  for (const NavigationTrialRecord& trial : record.trials) virtual_s += trial.end_s;
  std::cerr << record.trials.size() << " runs, " << virtual_s << " s of virtual time in " << seconds
            << " s\n";
  return Deliver(record, seconds, arguments.json, arguments.output);
}

}  // namespace

int Deliver(const NavigationRecord& record, double seconds, bool json,
            const std::filesystem::path& output) {
  return DeliverText(
      {NavigationRecordText(record), NavigationTables(record), NavigationPage(record)}, seconds,
      json, output);
}

void AddExperimentNavigationCommand(CLI::App& experiment, int* exit_code) {
  auto arguments = std::make_shared<NavigationArguments>();
  arguments->robot_file = config::InstalledFile("scripts/config/robot.yaml");
  arguments->sim_file = config::InstalledFile("scripts/config/sim.yaml");
  CLI::App* command = experiment.add_subcommand(
      "navigation",
      "Section 4.3: the simulated robot looks for a geon in a pen and drives to where it could "
      "scan "
      "it, in virtual time; pictures are replaced by what they would show.");
  command->add_option("--pens", arguments->pens, "random pens")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command
      ->add_option("--pen", arguments->pen,
                   "of one kind only: boxes, u_trap, dead_end, gap, empty or unreachable; mixed: "
                   "half boxes, the others up to gap in equal parts")
      ->check(
          CLI::IsMember({"mixed", "boxes", "u_trap", "dead_end", "gap", "empty", "unreachable"}))
      ->capture_default_str();
  command->add_option("--worlds", arguments->worlds, "world files instead of random pens")
      ->check(CLI::ExistingFile);
  command
      ->add_option("--barn", arguments->barn,
                   "folder with worlds.csv and obstacles.csv of BARN's kind: courses through "
                   "cylinders, each to be driven to its goal")
      ->check(CLI::ExistingDirectory)
      ->excludes("--worlds")
      ->excludes("--pens")
      ->excludes("--pen");
  command
      ->add_option(
          "--planner", arguments->planner,
          "thesis: the vertex rule of section 4.3; map: by a map of obstacles; the default "
          "is the robot file's")
      ->check(CLI::IsMember({"thesis", "map"}));
  command
      ->add_option("--sensors", arguments->sensors,
                   "perfect: all obstacles in sight known without an error; real: as the simulator "
                   "has them; degraded: sonars often deaf or fooled, crosstalk, 2 % drift, glare")
      ->check(CLI::IsMember({"perfect", "real", "degraded"}))
      ->capture_default_str();
  command
      ->add_option("--longest-s", arguments->longest_s,
                   "a run that takes longer is trapped; 120, with --barn 240")
      ->check(CLI::Range(1.0, 3600.0));
  command->add_option("--config", arguments->robot_file, "robot file")->capture_default_str();
  command->add_option("--sim-config", arguments->sim_file, "what the simulated robot is like")
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "of the first pen; the others count up")
      ->capture_default_str();
  AddSpreadArguments(*command, &arguments->shard, &arguments->jobs);
  command->add_option("-o,--output", arguments->output, "folder for results.json and report.html");
  command->add_flag("--json", arguments->json, "print results.json instead of the tables");
  command->footer(
      "Examples:\n  geon experiment navigation --pens 1000 --jobs 2 -o pens\n"
      "  geon experiment navigation --pens 1000 --planner thesis\n"
      "  geon experiment navigation --worlds hall.yaml --sensors perfect\n"
      "  geon experiment navigation --barn ~/barn --sensors real --jobs 2 -o courses");
  command->callback([arguments, exit_code] { *exit_code = RunNavigation(*arguments); });
}

}  // namespace geon::cli
