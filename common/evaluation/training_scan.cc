#include "evaluation/training_scan.h"

#include <cmath>
#include <optional>
#include <random>

#include "base/angles.h"
#include "evaluation/object_tracer.h"
#include "evaluation/scan_maker.h"
#include "evaluation/training_shape.h"
#include "evaluation/trial_random.h"
#include "geometry/rigid_transform.h"

namespace geon::evaluation {
namespace {

struct Setting {
  ViewOptions view;
  FaultOptions faults;
  RangefinderOptions rangefinder;
};

Setting RobotSetting(std::mt19937_64& random) {
  Setting setting;
  setting.view.range_m = Uniform(random, 0.7, 1.75);
  setting.view.elevation_rad = RadiansFromDegrees(Uniform(random, 8.0, 82.0));
  setting.view.floor = random() % 3 == 0;
  setting.rangefinder.baseline_m = Uniform(random, 0.05, 0.13);
  setting.faults = RobotFaults(random);
  return setting;
}

Setting DepthCameraSetting(std::mt19937_64& random) {
  Setting setting;
  setting.view.range_m = Uniform(random, 0.4, 1.2);
  setting.view.elevation_rad = RadiansFromDegrees(Uniform(random, 20.0, 60.0));
  setting.view.floor = true;
  setting.rangefinder.depth_camera = true;
  setting.rangefinder.focal_px = Uniform(random, 450.0, 800.0);
  setting.rangefinder.baseline_m = Uniform(random, 30.0, 100.0) / setting.rangefinder.focal_px;
  setting.rangefinder.color_above_m = 0.0;
  FaultOptions& faults = setting.faults;
  faults.noise_px = Uniform(random, 0.02, 0.15);
  faults.speckle_px = Uniform(random, 0.0, 0.2);
  faults.dropout_1 = random() % 2 == 0 ? 0.0 : Uniform(random, 0.0, 0.1);
  faults.misplacement_1 = Uniform(random, 0.0, 0.03);
  faults.attitude_rad = RadiansFromDegrees(Uniform(random, 0.0, 3.0));
  faults.step_px = random() % 2 == 0 ? 0.0 : Uniform(random, 0.05, 0.25);
  faults.patch_px = Uniform(random, 0.0, 4.0);
  if (random() % 2 == 0) {
    const double incidence_rad = RadiansFromDegrees(Uniform(random, 60.0, 85.0));
    faults.steepest_m =
        setting.view.range_m / setting.rangefinder.focal_px * std::tan(incidence_rad);
  }
  faults.edge_px = Uniform(random, 0.0, 3.0);
  faults.shadow_px = Uniform(random, 0.0, 6.0);
  faults.offset_px = Uniform(random, 0.0, 1.0);
  faults.ripple_px = Uniform(random, 0.0, 0.4);
  return setting;
}

// Something that stands close to the shape.
geons::TriangleMesh MakeNeighbour(const geons::TriangleMesh& shape, std::mt19937_64& random) {
  geons::TriangleMesh mesh = MakeTrainingShape(random).mesh;
  const double away_rad = Uniform(random, 0.0, 2.0 * kPi);
  const double apart_m = 0.5 * geons::Bounds(shape).diagonal().head<2>().norm() +
                         0.5 * geons::Bounds(mesh).diagonal().head<2>().norm() +
                         Uniform(random, 0.0, 0.15);
  geons::Transform(
      geometry::MakeTransform(geometry::RotationAboutZ(Uniform(random, 0.0, kPi)),
                              {apart_m * std::cos(away_rad), apart_m * std::sin(away_rad), 0.0}),
      &mesh);
  return mesh;
}

}  // namespace

FaultOptions RobotFaults(std::mt19937_64& random) {
  FaultOptions faults;
  faults.noise_px = random() % 8 == 0 ? 0.0 : 0.03 * std::exp(Uniform(random, 0.0, std::log(8.0)));
  faults.misplacement_1 = Uniform(random, 0.0, 0.06);
  const int more = static_cast<int>(random() % 4) - 1;
  for (int k = 0; k < more; ++k) {
    const double strength = Uniform(random, 0.2, 1.3);
    switch (random() % 5) {
      case 0:
        faults.outliers_1 = 0.02 * strength;
        break;
      case 1:
        faults.dropout_1 = 0.12 * strength;
        break;
      case 2:
        faults.speckle_px = 0.2 * strength;
        break;
      case 3:
        faults.floor_cut_m = 0.015 * strength;
        break;
      default:
        faults.attitude_rad = RadiansFromDegrees(2.0 * strength);
        break;
    }
  }
  return faults;
}

std::vector<sensor::ScanSet> MakeTrainingScans(uint64_t seed, uint64_t t, int views) {
  std::mt19937_64 random = TrialRandom(~seed, t);
  const TrainingShape shape = MakeTrainingShape(random);
  std::optional<geons::TriangleMesh> neighbour;
  if (random() % 8 == 0) neighbour = MakeNeighbour(shape.mesh, random);
  const ObjectTracer object(shape.mesh, neighbour ? &*neighbour : nullptr);
  std::vector<sensor::ScanSet> scans;
  for (int k = 0; k < views; ++k) {
    Setting setting = random() % 3 == 0 ? DepthCameraSetting(random) : RobotSetting(random);
    setting.view.azimuth_rad = Uniform(random, 0.0, 2.0 * kPi);
    scans.push_back(MakeScan(object, setting.view, setting.faults, setting.rangefinder, random));
    scans.back().truth = shape.label;
  }
  return scans;
}

}  // namespace geon::evaluation
