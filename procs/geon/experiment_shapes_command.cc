#include <chrono>
#include <iostream>
#include <memory>

#include "config/daemon_arguments.h"
#include "procs/geon/commands.h"
#include "procs/geon/experiment_commands.h"
#include "procs/geon/experiment_page.h"
#include "procs/geon/experiment_record.h"
#include "procs/geon/experiment_shapes.h"
#include "procs/geon/recognition_arguments.h"
#include "recognition/recognize_geon.h"

namespace geon::cli {
namespace {

constexpr double kMeshSize_m = 0.2;

struct ShapesArguments {
  RecognitionArguments recognition;
  std::filesystem::path objects, meshes, output;
  evaluation::Family family = evaluation::Family::kSuperquadric;
  std::string stress = "none", elevation_deg = "30:70", shard = "1/1";
  double range_m = 1.0, noise_px = 0.1;
  bool ortho = false, floor = false, json = false;
  uint64_t seed = 1;
  int jobs = 1;
};

std::string CheckElevation(const std::string& text) {
  int low_deg = 0, high_deg = 0;
  const bool good = ReadNumberPair(text, ':', &low_deg, &high_deg) && low_deg >= 0 &&
                    low_deg < high_deg && high_deg <= 90 && low_deg % 10 == 0 && high_deg % 10 == 0;
  return good ? "" : "must be LO:HI, multiples of 10 from 0 to 90, LO below HI";
}

Result<std::vector<ShownObject>> LoadObjects(const ShapesArguments& arguments) {
  if (!arguments.meshes.empty()) return LoadShownMeshes(arguments.meshes, kMeshSize_m);
  if (!arguments.objects.empty()) return LoadShownObjects(arguments.objects, arguments.family);
  return ThesisShownObjects(arguments.family);
}

nlohmann::json Conditions(const ShapesArguments& arguments) {
  const bool polygon = arguments.family == evaluation::Family::kPolygon;
  const nlohmann::json curvature = arguments.recognition.curvature.empty()
                                       ? nlohmann::json()
                                       : nlohmann::json(arguments.recognition.curvature);
  const nlohmann::json smoothing = arguments.recognition.smoothing.empty()
                                       ? nlohmann::json()
                                       : nlohmann::json(arguments.recognition.smoothing);
  const nlohmann::json background = arguments.recognition.background.empty()
                                        ? nlohmann::json()
                                        : nlohmann::json(arguments.recognition.background);
  return {{"range_m", arguments.range_m},
          {"noise_px", arguments.noise_px},
          {"stress", arguments.stress},
          {"floor", arguments.floor},
          {"ortho", arguments.ortho},
          {"elevation_deg", arguments.elevation_deg},
          {"family", polygon ? "polygon" : "superquadric"},
          {"objects", arguments.objects.filename().string()},
          {"meshes", arguments.meshes.filename().string()},
          {"curvature", curvature},
          {"smoothing", smoothing},
          {"background", background}};
}

int RunShapes(const ShapesArguments& arguments) {
  Result<std::vector<ShownObject>> objects = LoadObjects(arguments);
  if (!objects.ok()) {
    std::cerr << "geon experiment shapes: " << objects.message() << '\n';
    return kFailed;
  }
  const auto begin = std::chrono::steady_clock::now();
  const evaluation::Stress stress = *evaluation::FindStress(arguments.stress);
  evaluation::SphereConditions conditions;
  conditions.seed = arguments.seed;
  conditions.range_m = arguments.range_m;
  conditions.orthographic = arguments.ortho;
  conditions.floor = arguments.floor || stress.floor;
  conditions.faults = stress.faults;
  conditions.faults.noise_px = arguments.noise_px;
  int low_deg = 0, high_deg = 0;
  ReadNumberPair(arguments.elevation_deg, ':', &low_deg, &high_deg);

  ShapeRecord record;
  const recognition::RecognitionOptions options = ToOptions(arguments.recognition);
  record.method = recognition::ToString(options.method);
  record.seed = arguments.seed;
  record.git = config::BuildVersion();
  record.conditions = Conditions(arguments);
  for (ShownObject& object : *objects) {
    if (stress.scale_1 != 1.0) Scale(stress.scale_1, &object.mesh);
    record.subjects.push_back(object.subject);
  }
  ShapeRun run = RunShapeTrials(
      *objects, evaluation::ViewingSphere(low_deg, high_deg), conditions,
      [&options](const sensor::ScanSet& scan) { return recognition::RecognizeGeon(scan, options); },
      ParseShard(arguments.shard), arguments.jobs);
  record.trials = std::move(run.trials);
  record.worst = std::move(run.worst);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::cerr << record.trials.size() << " scans made and recognised in " << seconds << " s\n";
  return Deliver(record, seconds, arguments.json, arguments.output);
}

}  // namespace

int Deliver(const ShapeRecord& record, double seconds, bool json,
            const std::filesystem::path& output) {
  return DeliverText({RecordText(record), RecordTables(record), ExperimentPage(record)}, seconds,
                     json, output);
}

void AddExperimentShapesCommand(CLI::App& experiment, int* exit_code) {
  auto arguments = std::make_shared<ShapesArguments>();
  CLI::App* command = experiment.add_subcommand(
      "shapes", "Tables 6.1-6.7 and figure 6.11: the viewing sphere round the 28 objects.");
  AddRecognitionArguments(*command, &arguments->recognition);
  auto* objects = command->add_option("--objects", arguments->objects, "other objects (YAML)");
  auto* meshes = command->add_option("--meshes", arguments->meshes,
                                     "folder of meshes with labels.csv, scaled to 20 cm");
  objects->excludes(meshes)->check(CLI::ExistingFile);
  meshes->check(CLI::ExistingDirectory);
  const std::map<std::string, evaluation::Family> families = {
      {"superquadric", evaluation::Family::kSuperquadric},
      {"polygon", evaluation::Family::kPolygon}};
  command->add_option("--family", arguments->family, "how the objects' surfaces are made")
      ->transform(CLI::CheckedTransformer(families, CLI::ignore_case))
      ->excludes(meshes);
  command->add_option("--range-m", arguments->range_m, "camera to the middle of the object")
      ->check(CLI::Range(0.3, 10.0))
      ->capture_default_str();
  command->add_option("--noise-px", arguments->noise_px, "on the stripe in the image")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  std::vector<std::string> names;
  for (const evaluation::Stress& stress : evaluation::Stresses()) names.push_back(stress.name);
  command->add_option("--stress", arguments->stress, "what else goes wrong (docs/experiments.md)")
      ->check(CLI::IsMember(names))
      ->capture_default_str();
  command->add_option("--elevation-deg", arguments->elevation_deg, "of the views: LO:HI")
      ->check(CheckElevation)
      ->capture_default_str();
  command->add_flag("--ortho", arguments->ortho, "parallel rays, no occlusion, as the thesis");
  command->add_flag("--floor", arguments->floor, "on a floor, whose points belong to the scans");
  command->add_option("--seed", arguments->seed, "of the noise")->capture_default_str();
  AddSpreadArguments(*command, &arguments->shard, &arguments->jobs);
  command->add_option("-o,--output", arguments->output, "folder for results.json and report.html");
  command->add_flag("--json", arguments->json, "print results.json instead of the tables");
  command->callback([arguments, exit_code] { *exit_code = RunShapes(*arguments); });
}

}  // namespace geon::cli
