#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "active_vision/fuse_views.h"
#include "active_vision/view_gain.h"
#include "sensor/geon_verdict.h"
#include "sensor/scan_set.h"

namespace geon::evaluation {

inline constexpr int kRoundViews = 2 * active_vision::kViewTurns;

// kTraining: training_shape.h, many of them hard to tell; kOrdinary: random_scan.h, what the robot
// usually gets to see.
enum class ShapeKind { kTraining = 0, kOrdinary = 1 };

// Scans of one random shape from all round it, kViewTurn_rad apart, the first from anywhere;
// `truth` is set. The shape stands on the floor or on a desk of 70 cm, 0.9 to 1.3 m from the
// robot's head, which looks down on it from 1.24 m: elevations of 39 to 54 and 15 to 30 degrees.
// Distance, support and the kind of faults (RobotFaults of training_scan.h) are those of all views,
// what they do is each one's own.
//
// Depends on (seed, t, kind) alone; of t below 2^40 none shares its random numbers with a scan of
// MakeTrainingScans of the same seed, nor with one of the other kind.
//
// Source: ours. Deviation from the robot: nothing else stands by, and points carry no colour.
std::vector<sensor::ScanSet> ScanRound(uint64_t seed, uint64_t t, ShapeKind kind);

// What method `evidence` says of the scans of a round: label, posterior, confidence and whether
// that decides, without what led to it.
struct ViewRound {
  GeonLabel truth = GeonLabel::kCuboid;
  std::array<sensor::GeonVerdict, kRoundViews> views;
};
ViewRound LookRound(uint64_t seed, uint64_t t, ShapeKind kind);

// What some views of a round say together. `looks` count on round the target, both ways: -1 is the
// last view.
sensor::GeonVerdict FuseLooks(const ViewRound& round, std::span<const int> looks,
                              const active_vision::FusionOptions& fusion);

}  // namespace geon::evaluation
