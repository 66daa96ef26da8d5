#include "evaluation/random_scan.h"

#include <random>

#include "base/angles.h"
#include "evaluation/object_tracer.h"
#include "evaluation/scan_maker.h"
#include "evaluation/trial_random.h"
#include "geons/geon_mesh.h"
#include "geons/polygon_geon.h"

namespace geon::evaluation {
namespace {

using geons::GeonShape;

// Fine enough that a facet of a round surface stays within 0.05 mm of it.
constexpr geons::MeshResolution kResolution{128, 96};

double Uniform(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Eigen::Vector3d RandomSize(GeonLabel label, std::mt19937_64& random) {
  const auto between = [&random](double low_m, double high_m) {
    return Uniform(random, low_m, high_m);
  };
  if (geons::IsBent(label)) return {between(.04, .09), between(.04, .10), between(.22, .36)};
  if (label == GeonLabel::kEllipsoid) {
    return {between(.10, .24), between(.10, .18), between(.10, .18)};
  }
  return {between(.08, .20), between(.08, .20), between(.09, .24)};
}

GeonShape DrawShape(std::mt19937_64& random) {
  GeonShape shape;
  shape.label = static_cast<GeonLabel>(random() % kGeonLabelCount);
  const auto positions = static_cast<uint64_t>(geons::StablePositionCount(shape.label));
  shape.position = 1 + static_cast<int>(random() % positions);
  shape.size_m = RandomSize(shape.label, random);
  if (geons::IsRound(shape.label) && shape.label != GeonLabel::kEllipsoid) {
    shape.size_m.y() = shape.size_m.x();
  }
  if (geons::IsTapered(shape.label)) shape.taper_1 = Uniform(random, 0.12, 0.8);
  if (geons::IsBent(shape.label)) {
    shape.bend_rad = RadiansFromDegrees(Uniform(random, 45.0, 180.0));
  }
  return shape;
}

// As RandomShape, but smaller, more slender, and more often only slightly tapered.
GeonShape StressedShape(std::mt19937_64& random) {
  for (;;) {
    GeonShape shape = DrawShape(random);
    shape.size_m *= Uniform(random, 0.5, 1.1);
    shape.size_m.z() *= Uniform(random, 0.75, 1.35);
    if (shape.label == GeonLabel::kEllipsoid) shape.size_m.x() *= Uniform(random, 0.75, 1.5);
    if (geons::IsTapered(shape.label)) {
      const double strength = Uniform(random, 0.0, 1.0);
      shape.taper_1 = 0.1 + 0.75 * strength * strength;
    }
    if (geons::Validate(shape).ok()) return shape;
  }
}

bool CanBeVessel(const GeonShape& shape) {
  return !geons::IsBent(shape.label) && shape.label != GeonLabel::kEllipsoid && shape.position != 2;
}

geons::TriangleMesh StressedMesh(const GeonShape& shape, Family* family, std::mt19937_64& random) {
  *family = random() % 2 == 0 ? Family::kSuperquadric : Family::kPolygon;
  const int sides = 24 + 4 * static_cast<int>(random() % 19);
  const double wall_1 = Uniform(random, 0.03, 0.2);
  const bool vessel = random() % 4 == 0;
  return vessel && CanBeVessel(shape) ? geons::PolygonVessel(shape, wall_1, sides)
                                      : ShapeMesh(shape, *family, sides);
}

// Noise from none to three times the usual; every second scan one or two faults more.
FaultOptions RandomFaults(std::mt19937_64& random) {
  FaultOptions faults;
  faults.noise_px = random() % 8 == 0 ? 0.0 : Uniform(random, 0.03, 0.3);
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
        faults.attitude_rad = RadiansFromDegrees(1.5 * strength);
        break;
    }
  }
  return faults;
}

}  // namespace

GeonShape RandomShape(std::mt19937_64& random) {
  for (;;) {
    const GeonShape shape = DrawShape(random);
    if (geons::Validate(shape).ok()) return shape;  // some cannot be bent as far as was drawn
  }
}

geons::TriangleMesh ShapeMesh(const GeonShape& shape, Family family, int sides) {
  return family == Family::kPolygon ? geons::PolygonGeon(shape, sides)
                                    : geons::GeonMesh(shape, kResolution);
}

RandomScan MakeRandomScan(uint64_t seed, uint64_t t) {
  std::mt19937_64 random = TrialRandom(seed, t);
  RandomScan result;
  result.shape = RandomShape(random);
  result.family = random() % 2 == 0 ? Family::kSuperquadric : Family::kPolygon;
  const int sides = 32 + 4 * static_cast<int>(random() % 17);
  const ObjectTracer object(ShapeMesh(result.shape, result.family, sides));

  ViewOptions view;
  view.range_m = result.range_m = Uniform(random, 0.9, 1.7);
  view.elevation_rad = result.elevation_rad = RadiansFromDegrees(Uniform(random, 15.0, 70.0));
  view.azimuth_rad = Uniform(random, 0.0, 2.0 * kPi);
  view.floor = random() % 2 == 0;
  FaultOptions faults;
  if (random() % 2 == 0) faults.misplacement_1 = 0.03;
  RangefinderOptions rangefinder;
  if (random() % 2 == 0) rangefinder.baseline_m = 0.125;
  result.scan = MakeScan(object, view, faults, rangefinder, random);
  result.scan.truth = result.shape.label;
  return result;
}

std::vector<RandomScan> MakeStressedScans(uint64_t seed, uint64_t t, int views) {
  std::mt19937_64 random = TrialRandom(~seed, t);
  RandomScan shown;
  shown.shape = StressedShape(random);
  const ObjectTracer object(StressedMesh(shown.shape, &shown.family, random));
  std::vector<RandomScan> scans;
  for (int k = 0; k < views; ++k) {
    ViewOptions view;
    view.range_m = shown.range_m = Uniform(random, 0.75, 1.9);
    view.elevation_rad = shown.elevation_rad = RadiansFromDegrees(Uniform(random, 3.0, 85.0));
    view.azimuth_rad = Uniform(random, 0.0, 2.0 * kPi);
    view.floor = random() % 3 == 0;
    RangefinderOptions rangefinder;
    rangefinder.baseline_m = Uniform(random, 0.05, 0.13);
    const FaultOptions faults = RandomFaults(random);
    shown.scan = MakeScan(object, view, faults, rangefinder, random);
    shown.scan.truth = shown.shape.label;
    scans.push_back(shown);
  }
  return scans;
}

}  // namespace geon::evaluation
