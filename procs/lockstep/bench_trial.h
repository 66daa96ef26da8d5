#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "procs/lockstep/lockstep_settings.h"
#include "procs/recognizer/stripe_calibration.h"
#include "sensor/geon_verdict.h"
#include "sensor/image.h"
#include "sensor/scan_set.h"
#include "sim/world.h"

namespace geon::lockstep {

// What stands on the bench, and how.
struct BenchTrial {
  std::variant<geons::GeonShape, sim::MeshShape> shape;
  double range_m = 1.0;  // from the B/W camera to the middle of the object
  double yaw_rad = 0.0;
  uint64_t seed = 1;  // of all noise, and of where the robot stands to some centimetres
};

// What came of it. Times are virtual, from the start of the run.
struct BenchOutcome {
  std::string end;                             // in the mission's words
  std::optional<sensor::GeonVerdict> verdict;  // nothing: the mission failed
  std::optional<double> seen_s;                // when a picture first showed the target's colour
  std::optional<double> whole_s;               // when the whole target was in view
  double end_s = 0.0;
  sensor::ScanSet scan;
  // The picture that the stripes were placed by (kBgr8), and the target's mask in it.
  sensor::Image view;
  std::vector<uint8_t> mask;
  // For each profile of the scan that has points on the middle of the target: where in the target's
  // box it lies, less where it was to lie; of the box's height or width.
  std::vector<double> misplaced_1;
};

// The bench of thesis section 6.2: the robot stands still before a desk 70 cm high, a geon is on
// the desk; it is looked for with the head, centred, scanned and named, by all daemons in lock-step
// with the simulated devices. Without a calibration, distances come from the rig. Errors: a mesh
// that cannot be used.
Result<BenchOutcome> RunBenchTrial(const LockstepSettings& settings,
                                   const std::optional<recognizer::StripeCalibration>& calibration,
                                   const BenchTrial& trial);

}  // namespace geon::lockstep
