#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "procs/base/base_config.h"
#include "sensor/base.h"
#include "sensor/laser_state.h"

namespace geon::base {

// Bearing in R of each bumper. The base does not turn with the steering, R does.
DriveGuard::Bearings BumperBearings(double bumper_zero_rad, double steer_rad);

// What the base has to say at once. The sensors' part only after a reading of them.
struct BaseNews {
  sensor::BaseState state;
  bool measured = false;
  sensor::SonarScan sonar;
  sensor::BumperState bumper;
  sensor::InfraredScan infrared;
};

// What a base daemon does, without bus, line and clock: the driver speaks to the robot, each state
// packet becomes news (20 Hz; while the base is not ready its state alone, 10 Hz), and commands
// drive as far as the DriveGuard lets them. Times are of one monotonic clock; `utime` is the same
// instant as it goes on the bus.
class BaseControl {
 public:
  explicit BaseControl(const BaseConfig& config);

  void Connected(double time_s) { driver_.Connected(time_s); }
  void Disconnected(double time_s) { driver_.Disconnected(time_s); }
  void Take(double time_s, const sensor::BaseCommand& command) {
    guard_.CommandArrived(time_s, command);
  }
  void Take(const sensor::LaserState& lasers) { guard_.LasersReported(lasers); }

  // One turn, often: what came over the line goes in, what to send comes out.
  [[nodiscard]] std::string Step(double time_s, int64_t utime, std::string_view bytes_in);
  // Stands, whatever was asked: for the way out.
  [[nodiscard]] std::string Halt(double time_s, std::string_view bytes_in);

  std::vector<BaseNews> TakeNews();
  const device::NomadReport& report() const { return driver_.report(); }
  // Why the robot does not do as it was told.
  sensor::BaseStop stop() const { return decision_.stop; }

 private:
  std::string Drive(double time_s);
  void TellState(double time_s, int64_t utime);
  void TellSample(double time_s, int64_t utime);

  BaseConfig config_;
  device::NomadDriver driver_;
  DriveGuard guard_;
  DriveDecision decision_;
  std::vector<BaseNews> news_;
  int taken_samples_ = 0;
  double told_s_ = 0.0;
  int32_t state_seq_ = 0;
  int32_t sensor_seq_ = 0;
};

}  // namespace geon::base
