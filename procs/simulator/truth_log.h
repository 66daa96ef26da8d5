#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>

#include "base/status.h"
#include "sim/simulated_robot.h"
#include "sim/world.h"

namespace geon::simulator {

// What really happened, for judging a run afterwards; no program of the robot reads it. JSON, one
// object a line, each with "utime" (clock of this host), "time_s" (of the world) and "event":
//   start    the world's objects and their true shapes, the seed
//   state    20 times a second: pose, speed, head, lasers, contacts
//   contact  the body begins or ceases to touch something, with the speed it has
//   laser    a laser begins or ceases to burn
//   stop
class TruthLog {
 public:
  static Result<std::unique_ptr<TruthLog>> Open(const std::filesystem::path& file,
                                                const sim::World& world, uint64_t seed,
                                                int64_t epoch_utime);
  ~TruthLog();

  // Called at every step; writes what has changed, and the state when it is due.
  void Observe(const sim::RobotTruth& truth);

 private:
  TruthLog(std::ofstream stream, int64_t epoch_utime);
  void WriteStart(const sim::World& world, uint64_t seed);
  void WriteState(const sim::RobotTruth& truth);

  std::ofstream stream_;
  int64_t epoch_utime_;
  sim::RobotTruth last_;
  double next_state_s_ = 0.0;
};

}  // namespace geon::simulator
