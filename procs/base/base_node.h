#pragma once

#include <cstdint>
#include <string>

#include "device/nomad_driver.h"
#include "device/serial_link.h"
#include "messaging/bus.h"
#include "messaging/health_reporter.h"
#include "messaging/poll_loop.h"
#include "messaging/rate_limiter.h"
#include "procs/base/base_config.h"
#include "procs/base/drive_guard.h"

namespace geon::base {

// Bearing in R of each bumper. The base does not turn with the steering, R does.
DriveGuard::Bearings BumperBearings(double bumper_zero_rad, double steer_rad);

// The one link to the base: each state packet becomes BASE_STATE, SONAR, BUMPER and INFRARED (20
// Hz); while the base is not ready, BASE_STATE says so (10 Hz). BASE_COMMAND drives as far as the
// DriveGuard lets it. On every way out of the loop the robot is stopped.
class BaseNode {
 public:
  BaseNode(const BaseConfig& config, messaging::Bus* bus, messaging::PollLoop* loop,
           messaging::HealthReporter* health);

 private:
  void Turn();
  void TakeSample(double time_s);
  void Drive(double time_s);
  void PublishState(double time_s);
  void PublishSensors(double time_s);
  void ReportHealth();
  int64_t SampleUtime(double time_s) const;
  void StopRobot();

  BaseConfig config_;
  device::SerialLink link_;
  device::NomadDriver driver_;
  DriveGuard guard_;
  DriveDecision decision_;
  messaging::Bus* bus_;
  messaging::HealthReporter* health_;
  int taken_samples_ = 0;
  double published_s_ = 0.0;
  int32_t state_seq_ = 0;
  int32_t sensor_seq_ = 0;
  std::string said_;  // trouble in the log last
  sensor::BaseStop said_stop_ = sensor::BaseStop::kNone;
};

}  // namespace geon::base
