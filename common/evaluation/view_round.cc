#include "evaluation/view_round.h"

#include <cmath>
#include <random>

#include "base/angles.h"
#include "evaluation/object_tracer.h"
#include "evaluation/random_scan.h"
#include "evaluation/scan_maker.h"
#include "evaluation/training_scan.h"
#include "evaluation/training_shape.h"
#include "evaluation/trial_random.h"
#include "recognition/recognize_geon.h"

namespace geon::evaluation {
namespace {

constexpr double kHeadHeight_m = 1.24;  // of the B/W camera of scripts/config/robot.yaml
constexpr double kDeskHeight_m = 0.70;
constexpr double kNearest_m = 0.9, kFarthestAway_m = 1.3;
constexpr double kLaserBaseline_m = 0.125;
constexpr uint64_t kStream = uint64_t{1} << 40U;  // beyond every t of MakeTrainingScans

TrainingShape MakeShape(ShapeKind kind, std::mt19937_64& random) {
  if (kind == ShapeKind::kTraining) return MakeTrainingShape(random);
  const geons::GeonShape shape = RandomShape(random);
  const Family family = random() % 2 == 0 ? Family::kSuperquadric : Family::kPolygon;
  const int sides = 32 + 4 * static_cast<int>(random() % 17);
  return {shape.label, ShapeMesh(shape, family, sides)};
}

// Where the head looks at an object from.
ViewOptions HeadView(double object_height_m, std::mt19937_64& random) {
  ViewOptions view;
  view.floor = true;
  const double support_m = random() % 2 == 0 ? 0.0 : kDeskHeight_m;
  const double away_m = Uniform(random, kNearest_m, kFarthestAway_m);
  const double above_m = kHeadHeight_m - support_m - 0.5 * object_height_m;
  view.range_m = std::hypot(away_m, above_m);
  view.elevation_rad = std::atan2(above_m, away_m);
  view.azimuth_rad = Uniform(random, 0.0, 2.0 * kPi);
  return view;
}

}  // namespace

std::vector<sensor::ScanSet> ScanRound(uint64_t seed, uint64_t t, ShapeKind kind) {
  std::mt19937_64 random = TrialRandom(~seed, kStream * (1 + static_cast<uint64_t>(kind)) + t);
  const TrainingShape shape = MakeShape(kind, random);
  const ObjectTracer object(shape.mesh);
  ViewOptions view = HeadView(object.height_m(), random);
  RangefinderOptions rangefinder;
  rangefinder.baseline_m = kLaserBaseline_m;
  const FaultOptions faults = RobotFaults(random);
  std::vector<sensor::ScanSet> scans;
  for (int k = 0; k < kRoundViews; ++k) {
    scans.push_back(MakeScan(object, view, faults, rangefinder, random));
    scans.back().truth = shape.label;
    view.azimuth_rad += active_vision::kViewTurn_rad;
  }
  return scans;
}

ViewRound LookRound(uint64_t seed, uint64_t t, ShapeKind kind) {
  ViewRound round;
  const std::vector<sensor::ScanSet> scans = ScanRound(seed, t, kind);
  round.truth = scans.front().truth.value();
  for (size_t k = 0; k < scans.size(); ++k) {
    const sensor::GeonVerdict verdict = recognition::RecognizeGeon(scans[k], {});
    round.views[k].label = verdict.label;
    round.views[k].confidence = verdict.confidence;
    round.views[k].posterior = verdict.posterior;
    round.views[k].decided = verdict.decided;
  }
  return round;
}

sensor::GeonVerdict FuseLooks(const ViewRound& round, std::span<const int> looks,
                              const active_vision::FusionOptions& fusion) {
  std::vector<sensor::GeonVerdict> verdicts;
  for (const int look : looks) {
    const int k = (look % kRoundViews + kRoundViews) % kRoundViews;
    verdicts.push_back(round.views[static_cast<size_t>(k)]);
  }
  return active_vision::FuseViews(verdicts, fusion);
}

}  // namespace geon::evaluation
