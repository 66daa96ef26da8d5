#include <filesystem>
#include <iostream>
#include <memory>

#include "base/angles.h"
#include "config/scan_set_json.h"
#include "config/text_file.h"
#include "evaluation/scan_maker.h"
#include "evaluation/trial_random.h"
#include "procs/geon/commands.h"
#include "sim/world_file.h"
#include "sim/world_scene.h"

namespace geon::cli {
namespace {

struct ScanArguments {
  std::filesystem::path world, mesh, output;
  double height_m = 0.2, range_m = 1.0, azimuth_deg = 0.0, elevation_deg = 30.0, noise_px = 0.1;
  uint64_t seed = 1;
};

struct Target {
  geons::TriangleMesh mesh;
  std::optional<GeonLabel> truth;
};

// A world's last geon or mesh, which is what a mission looks for, as it is turned there.
Result<Target> TargetOfWorld(const std::filesystem::path& file) {
  const Result<sim::World> world = sim::LoadWorld(file);
  if (!world.ok()) return world.status();
  for (auto object = world->objects.rbegin(); object != world->objects.rend(); ++object) {
    const bool is_target = std::holds_alternative<geons::GeonShape>(object->shape) ||
                           std::holds_alternative<sim::MeshShape>(object->shape);
    if (!is_target) continue;
    Result<geons::TriangleMesh> mesh = sim::ObjectMesh(*world, *object);
    if (!mesh.ok()) return mesh.status();
    return Target{std::move(*mesh), sim::TrueLabel(*object)};
  }
  return Status::Error(file.string() + ": this world has no geon and no mesh to scan");
}

Result<Target> LoadTarget(const ScanArguments& arguments) {
  if (!arguments.world.empty()) return TargetOfWorld(arguments.world);
  Result<geons::TriangleMesh> mesh = sim::LoadObj(arguments.mesh);
  if (!mesh.ok()) return mesh.status();
  const double height_m = geons::Bounds(*mesh).sizes().z();
  if (!(height_m > 0.0)) return Status::Error(arguments.mesh.string() + ": it has no height");
  for (Eigen::Vector3d& p_m : mesh->vertices_m) p_m *= arguments.height_m / height_m;
  return Target{std::move(*mesh), std::nullopt};
}

int Scan(const ScanArguments& arguments) {
  Result<Target> target = LoadTarget(arguments);
  Status status = target.status();
  if (target.ok()) {
    geons::StandOnGround(&target->mesh);
    evaluation::ViewOptions view;
    view.range_m = arguments.range_m;
    view.azimuth_rad = RadiansFromDegrees(arguments.azimuth_deg);
    view.elevation_rad = RadiansFromDegrees(arguments.elevation_deg);
    view.floor = true;
    evaluation::FaultOptions faults;
    faults.noise_px = arguments.noise_px;
    std::mt19937_64 random = evaluation::TrialRandom(arguments.seed, 0);
    sensor::ScanSet scan =
        evaluation::MakeScan(evaluation::ObjectTracer(target->mesh), view, faults, {}, random);
    scan.truth = target->truth;
    status = config::WriteFileAtomically(arguments.output, config::SerializeScanSet(scan));
  }
  if (status.ok()) return kOk;
  std::cerr << "geon scan: " << status.message() << '\n';
  return kFailed;
}

}  // namespace

void AddScanCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<ScanArguments>();
  CLI::App* command =
      app.add_subcommand("scan", "Makes a scan set: what six stripes measure of an object.");
  CLI::Option_group* what = command->add_option_group("what");
  what->add_option("--world", arguments->world, "its last geon or mesh, on a floor of its own")
      ->check(CLI::ExistingFile);
  what->add_option("--mesh", arguments->mesh, "Wavefront OBJ, z up")->check(CLI::ExistingFile);
  what->require_option(1);
  command->add_option("--height-m", arguments->height_m, "of the mesh, which is scaled to it")
      ->check(CLI::Range(0.001, 2.0))
      ->capture_default_str();
  command->add_option("--range-m", arguments->range_m, "camera to the middle of the object")
      ->check(CLI::Range(0.3, 10.0))
      ->capture_default_str();
  command->add_option("--azimuth-deg", arguments->azimuth_deg, "of the camera round the object")
      ->capture_default_str();
  command->add_option("--elevation-deg", arguments->elevation_deg, "of the camera above it")
      ->check(CLI::Range(0.0, 89.0))
      ->capture_default_str();
  command->add_option("--noise-px", arguments->noise_px, "on the stripe in the image")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "of the noise")->capture_default_str();
  command->add_option("-o,--output", arguments->output, "scan set to write")->required();
  command->callback([arguments, exit_code] { *exit_code = Scan(*arguments); });
}

}  // namespace geon::cli
