#include <chrono>
#include <iostream>
#include <memory>

#include "config/daemon_arguments.h"
#include "config/text_file.h"
#include "procs/geon/bench_page.h"
#include "procs/geon/commands.h"
#include "procs/geon/experiment_bench.h"
#include "procs/geon/experiment_commands.h"
#include "procs/geon/progress.h"
#include "procs/geon/recognition_arguments.h"

namespace geon::cli {
namespace {

constexpr double kBenchMesh_m = 0.2;

struct BenchArguments {
  RecognitionArguments recognition;
  std::filesystem::path meshes, output, robot_file, sim_file, calibration;
  BenchPlan plan;
  std::string scan;  // the robot file's
  std::string shard = "1/1";
  bool json = false;
  int jobs = 1;
};

int FailBench(const Status& status) {
  std::cerr << "geon experiment bench: " << status.message() << '\n';
  return kFailed;
}

int RunBenchCommand(const BenchArguments& arguments) {
  Result<lockstep::LockstepSettings> settings =
      lockstep::LoadLockstepSettings(arguments.robot_file, arguments.sim_file);
  if (!settings.ok()) return FailBench(settings.status());
  auto& recognition = settings->recognizer.assembler.recognition;
  recognition = ToOptions(arguments.recognition, recognition);
  if (!arguments.calibration.empty()) {
    settings->recognizer.calibration_dir = arguments.calibration;
    settings->recognizer.ranging = recognizer::Ranging::kLookUpTable;
  }
  mission::ScanMode& scan = settings->mission.looking.scan;
  scan = mission::ScanModeFromString(arguments.scan).value_or(scan);
  const Result<std::optional<recognizer::StripeCalibration>> calibration =
      recognizer::LoadCalibration(settings->recognizer);
  if (!calibration.ok()) return FailBench(calibration.status());
  Result<std::vector<BenchObject>> objects = ThesisBenchObjects();
  if (!arguments.meshes.empty()) objects = LoadBenchMeshes(arguments.meshes, kBenchMesh_m);
  if (!objects.ok()) return FailBench(objects.status());

  BenchRecord record;
  record.method = recognition::ToString(recognition.method);
  record.seed = arguments.plan.seed;
  record.git = config::BuildVersion();
  record.conditions = {
      {"ranges_m", arguments.plan.ranges_m},
      {"poses", arguments.plan.poses},
      {"scan", ToString(scan)},
      {"meshes", arguments.meshes.filename().string()},
      {"calibration", recognizer::CalibrationHash(settings->recognizer, *calibration)}};
  const auto begin = std::chrono::steady_clock::now();
  Progress progress("geon experiment bench");
  Result<BenchRun> run =
      RunBench(*settings, *calibration, *objects, arguments.plan, ParseShard(arguments.shard),
               arguments.jobs, [&](double done) { progress.Say(done); });
  if (!run.ok()) return FailBench(run.status());
  record.trials = std::move(run->trials);
  record.worst = std::move(run->worst);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::cerr << record.trials.size() << " runs on the bench in " << seconds << " s\n";
  return Deliver(record, seconds, arguments.json, arguments.output);
}

}  // namespace

int Deliver(const BenchRecord& record, double seconds, bool json,
            const std::filesystem::path& output) {
  return DeliverText({BenchRecordText(record), BenchTables(record), BenchPage(record)}, seconds,
                     json, output);
}

void AddExperimentBenchCommand(CLI::App& experiment, int* exit_code) {
  auto arguments = std::make_shared<BenchArguments>();
  arguments->robot_file = config::InstalledFile("scripts/config/robot.yaml");
  arguments->sim_file = config::InstalledFile("scripts/config/sim.yaml");
  CLI::App* command = experiment.add_subcommand(
      "bench",
      "Tables 6.8-6.10: the simulated robot names geons on a desk, through rendered pictures, "
      "serial protocols and calibration, in virtual time.");
  AddRecognitionArguments(*command, &arguments->recognition);
  command->add_option("--range-m", arguments->plan.ranges_m, "B/W camera to the geon's middle")
      ->delimiter(',')
      ->check(CLI::Range(0.7, 2.0))
      ->capture_default_str();
  command
      ->add_option("--poses", arguments->plan.poses,
                   "of each object at each range: stable positions in turn, yaws all round")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command
      ->add_option("--meshes", arguments->meshes,
                   "folder of meshes with labels.csv, scaled to 20 cm, instead of the 28 objects")
      ->check(CLI::ExistingDirectory);
  command
      ->add_option(
          "--scan", arguments->scan,
          "stop: the head stands for each stripe; sweep: stripes are taken while it turns; "
          "the default is the robot file's")
      ->check(CLI::IsMember({"stop", "sweep"}));
  command
      ->add_option("--calibration", arguments->calibration,
                   "folder of look-up tables to range by, instead of the robot file's way")
      ->check(CLI::ExistingDirectory);
  command->add_option("--config", arguments->robot_file, "robot file")->capture_default_str();
  command->add_option("--sim-config", arguments->sim_file, "what the simulated robot is like")
      ->capture_default_str();
  command->add_option("--seed", arguments->plan.seed, "of poses and noise")->capture_default_str();
  AddSpreadArguments(*command, &arguments->shard, &arguments->jobs);
  command->add_option("-o,--output", arguments->output, "folder for results.json and report.html");
  command->add_flag("--json", arguments->json, "print results.json instead of the tables");
  command->footer(
      "Examples:\n  geon experiment bench --jobs 2 -o bench\n"
      "  geon experiment bench --method thesis --range-m 1.0 --poses 4");
  command->callback([arguments, exit_code] { *exit_code = RunBenchCommand(*arguments); });
}

}  // namespace geon::cli
