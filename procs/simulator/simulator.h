#pragma once

#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/status.h"
#include "geometry/sensor_rig.h"
#include "procs/simulator/frame_publisher.h"
#include "procs/simulator/pty_port.h"
#include "procs/simulator/truth_log.h"
#include "sim/simulated_robot.h"

namespace geon::simulator {

struct SimulatorSettings {
  sim::World world;
  geometry::SensorRig rig;
  sim::SimOptions options;
  uint64_t seed = 1;
  std::filesystem::path run_directory;
  std::filesystem::path truth_file;
};

// The simulated robot in real time, at the hardware boundary: <run>/ptu.tty, base.tty and
// lasers.tty lead to its serial lines, <run>/*.frames are its cameras. Everything is taken down
// when it is destroyed.
class Simulator {
 public:
  static Result<std::unique_ptr<Simulator>> Open(const SimulatorSettings& settings);

  // Serves the devices 500 times a second until `stop` is set.
  void Run(const std::atomic<bool>& stop);

 private:
  Simulator(std::unique_ptr<sim::SimulatedRobot> robot, int64_t epoch_utime);
  void Serve(double time_s);

  std::unique_ptr<sim::SimulatedRobot> robot_;
  int64_t epoch_utime_;  // when the world's time was 0
  std::array<std::optional<PtyPort>, sim::kDevices.size()> ports_;
  std::unique_ptr<FramePublisher> frames_;
  std::unique_ptr<TruthLog> truth_;
};

}  // namespace geon::simulator
