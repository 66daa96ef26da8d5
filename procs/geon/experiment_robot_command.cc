#include <chrono>
#include <iostream>
#include <map>
#include <memory>

#include "config/daemon_arguments.h"
#include "config/text_file.h"
#include "procs/geon/commands.h"
#include "procs/geon/experiment_commands.h"
#include "procs/geon/experiment_robot.h"
#include "procs/geon/progress.h"
#include "procs/geon/recognition_arguments.h"

namespace geon::cli {
namespace {

struct RobotArguments {
  RecognitionArguments recognition;
  RobotPlan plan;
  std::string place = "any";
  std::string planner, scan;  // the robot file's
  std::filesystem::path output, robot_file, sim_file;
  std::string shard = "1/1";
  bool inventory = false, calm = false;
  bool json = false;
  int jobs = 1;
};

const std::map<std::string, sim::GeonPlace> kPlaces = {{"any", sim::GeonPlace::kAny},
                                                       {"floor", sim::GeonPlace::kFloor},
                                                       {"box", sim::GeonPlace::kBox}};

int FailRobot(const Status& status) {
  std::cerr << "geon experiment robot: " << status.message() << '\n';
  return kFailed;
}

Result<lockstep::LockstepSettings> RobotSettings(const RobotArguments& arguments) {
  Result<lockstep::LockstepSettings> settings =
      lockstep::LoadLockstepSettings(arguments.robot_file, arguments.sim_file);
  if (!settings.ok()) return settings;
  auto& recognition = settings->recognizer.assembler.recognition;
  recognition = ToOptions(arguments.recognition, recognition);
  mission::PlannerKind& planner = settings->mission.driving.planner;
  planner = mission::PlannerKindFromString(arguments.planner).value_or(planner);
  settings->mission.inventory = arguments.inventory || arguments.plan.geons > 1;
  mission::ScanMode& scan = settings->mission.looking.scan;
  scan = mission::ScanModeFromString(arguments.scan).value_or(scan);
  return settings;
}

nlohmann::json RobotConditions(const RobotArguments& arguments,
                               const lockstep::LockstepSettings& settings,
                               const std::optional<recognizer::StripeCalibration>& calibration) {
  nlohmann::json worlds = nlohmann::json::array();
  for (const std::filesystem::path& file : arguments.plan.worlds) {
    worlds.push_back(file.filename().string());
  }
  const bool random = worlds.empty();
  const RecognitionArguments& said = arguments.recognition;
  return {{"runs", random ? arguments.plan.runs : static_cast<int>(worlds.size())},
          {"place", random ? arguments.place : ""},
          {"geons", random ? arguments.plan.geons : 0},  // 0: as the files have it
          {"trouble", !arguments.calm},
          {"inventory", settings.mission.inventory},
          {"worlds", std::move(worlds)},
          {"planner", ToString(settings.mission.driving.planner)},
          {"scan", ToString(settings.mission.looking.scan)},
          {"curvature", said.curvature},  // empty, as the next two: the robot file's
          {"smoothing", said.smoothing},
          {"background", said.background},
          {"calibration", recognizer::CalibrationHash(settings.recognizer, calibration)},
          {"longest_s", arguments.plan.longest_s}};
}

int RunRobotCommand(const RobotArguments& arguments) {
  const Result<lockstep::LockstepSettings> settings = RobotSettings(arguments);
  if (!settings.ok()) return FailRobot(settings.status());
  const Result<std::optional<recognizer::StripeCalibration>> calibration =
      recognizer::LoadCalibration(settings->recognizer);
  if (!calibration.ok()) return FailRobot(calibration.status());
  RobotPlan plan = arguments.plan;
  plan.trouble = !arguments.calm;
  plan.place = kPlaces.at(arguments.place);
  const Result<std::vector<RobotCase>> cases =
      RobotCases(plan, settings->sim, ParseShard(arguments.shard));
  if (!cases.ok()) return FailRobot(cases.status());

  RobotRecord record;
  record.method = ToString(settings->recognizer.assembler.recognition.method);
  record.seed = plan.seed;
  record.git = config::BuildVersion();
  record.conditions = RobotConditions(arguments, *settings, *calibration);
  const auto begin = std::chrono::steady_clock::now();
  Progress progress("geon experiment robot");
  const Status run = RunRobotCases(
      *settings, *calibration, *cases, plan.longest_s, arguments.jobs,
      [&](double done) { progress.Say(done); }, &record);
  if (!run.ok()) return FailRobot(run);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  double virtual_s = 0.0;
  for (const RobotTrialRecord& trial : record.trials) virtual_s += trial.end_s;
  std::cerr << record.trials.size() << " missions, " << virtual_s << " s of virtual time in "
            << seconds << " s\n";
  return Deliver(record, seconds, arguments.json, arguments.output);
}

void AddRobotOptions(CLI::App* command, RobotArguments* arguments) {
  RobotPlan& plan = arguments->plan;
  CLI::Option* runs = command->add_option("--runs", plan.runs, "missions, each in a random pen")
                          ->check(CLI::Range(1, 1000000))
                          ->capture_default_str();
  CLI::Option* place = command
                           ->add_option("--place", arguments->place,
                                        "where the geon stands: floor, box (70 cm), or any: half "
                                        "of the runs each")
                           ->check(CLI::IsMember({"any", "floor", "box"}))
                           ->capture_default_str();
  CLI::Option* geons =
      command->add_option("--geons", plan.geons, "in a pen; of several all are to be named")
          ->check(CLI::Range(1, 4))
          ->capture_default_str();
  command->add_option("--worlds", plan.worlds, "world files instead of random pens")
      ->check(CLI::ExistingFile)
      ->excludes(runs)
      ->excludes(place)
      ->excludes(geons);
  command->add_flag("--inventory", arguments->inventory,
                    "with --worlds: name every geon of the pen, not just the first one");
  command->add_flag("--calm", arguments->calm,
                    "without the trouble of real rooms and robots: drift, grooves, glare, other "
                    "light, lost frames, paint that is not quite the colour");
  command
      ->add_option("--planner", arguments->planner,
                   "thesis: the vertex rule of section 4.3; map: by a map of obstacles; the "
                   "default is the robot file's")
      ->check(CLI::IsMember({"thesis", "map"}));
  command
      ->add_option("--scan", arguments->scan,
                   "stop: the head stands for each stripe; sweep: stripes are taken while it "
                   "turns; the default is the robot file's")
      ->check(CLI::IsMember({"stop", "sweep"}));
  command
      ->add_option("--longest-s", plan.longest_s,
                   "a run that takes longer is ended and counts as trapped")
      ->check(CLI::Range(1.0, 3600.0))
      ->capture_default_str();
  command
      ->add_option("--seed", plan.seed,
                   "of the first run's world and of all its noise; the others count up")
      ->capture_default_str();
}

}  // namespace

int Deliver(const RobotRecord& record, double seconds, bool json,
            const std::filesystem::path& output) {
  return DeliverText({RobotRecordText(record), RobotTables(record), RobotPage(record)}, seconds,
                     json, output);
}

void AddExperimentRobotCommand(CLI::App& experiment, int* exit_code) {
  auto arguments = std::make_shared<RobotArguments>();
  arguments->robot_file = config::InstalledFile("scripts/config/robot.yaml");
  arguments->sim_file = config::InstalledFile("scripts/config/sim.yaml");
  CLI::App* command = experiment.add_subcommand(
      "robot",
      "Section 6.3: whole missions. The simulated robot searches a pen for the geon, drives up to "
      "it, scans and names it: rendered pictures, serial protocols and calibration included, in "
      "virtual time.");
  AddRobotOptions(command, arguments.get());
  AddRecognitionArguments(*command, &arguments->recognition);
  command->add_option("--config", arguments->robot_file, "robot file")->capture_default_str();
  command->add_option("--sim-config", arguments->sim_file, "what the simulated robot is like")
      ->capture_default_str();
  AddSpreadArguments(*command, &arguments->shard, &arguments->jobs);
  command->add_option("-o,--output", arguments->output, "folder for results.json and report.html");
  command->add_flag("--json", arguments->json, "print results.json instead of the tables");
  command->footer(
      "Examples:\n  geon experiment robot --jobs 2 -o missions\n"
      "  geon experiment robot --runs 100 --geons 3 -o inventories\n"
      "  geon experiment robot --runs 30 --method thesis --planner thesis\n"
      "The run of seed 7 again, then the same in real time:\n"
      "  geon world --seed 7 --on floor -o pen7.yaml\n"
      "  geon experiment robot --calm --worlds pen7.yaml --seed 7 -o again\n"
      "  scripts/demo --world pen7.yaml --seed 7");
  command->callback([arguments, exit_code] { *exit_code = RunRobotCommand(*arguments); });
}

}  // namespace geon::cli
