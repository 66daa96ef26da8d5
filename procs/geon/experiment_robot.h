#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "procs/geon/experiment_shapes.h"
#include "procs/geon/robot_record.h"
#include "procs/lockstep/lockstep_settings.h"
#include "procs/recognizer/stripe_calibration.h"
#include "sim/random_world.h"
#include "sim/world.h"

namespace geon::cli {

// Which missions to run. Mission t has seed + t for its world and for all noise.
struct RobotPlan {
  int runs = 200;
  sim::GeonPlace place = sim::GeonPlace::kAny;  // any: on the floor for even t, on a box for odd
  int geons = 1;                                // in a pen; of several all are to be named
  bool trouble = true;                          // sim/trouble.h
  std::vector<std::filesystem::path> worlds;    // in place of random ones
  uint64_t seed = 1;
  double longest_s = 310.0;  // a mission gives up by itself after 300 s
};

// A mission to be run.
struct RobotCase {
  int t = 0;
  uint64_t seed = 0;
  std::string name;  // of the world's file; empty: a random world
  sim::World world;
  sim::SimOptions sim;
};

// The world as `geon world` writes it and geon-sim reads it, so that a run can be had again from
// that file, to the bit.
sim::World RandomWorldAsWritten(uint64_t seed, sim::GeonPlace place, int geons = 1);

// A shard's missions, `sim` being the simulated robot before any trouble. Errors: a world file that
// cannot be read, has no geon, or does not say what its mesh is.
Result<std::vector<RobotCase>> RobotCases(const RobotPlan& plan, const sim::SimOptions& sim,
                                          Shard shard);

// Runs them, `jobs` at a time, and puts trials, maps and the film into `record`; `progress` is told
// the share that is done, from any thread. Errors: a mesh that cannot be used.
Status RunRobotCases(const lockstep::LockstepSettings& settings,
                     const std::optional<recognizer::StripeCalibration>& calibration,
                     const std::vector<RobotCase>& cases, double longest_s, int jobs,
                     const std::function<void(double)>& progress, RobotRecord* record);

}  // namespace geon::cli
