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

}  // namespace geon::evaluation
