#pragma once

#include <string>

#include "device/ptu_driver.h"
#include "device/serial_link.h"
#include "messaging/bus.h"
#include "messaging/health_reporter.h"
#include "messaging/poll_loop.h"
#include "procs/ptu/ptu_config.h"
#include "sensor/ptu.h"

namespace geon::ptu {

// What the driver knows at `time_s`, as a message; `utime` is the same instant on the other clock.
sensor::PtuState StateFromReport(const device::PtuReport& report, double time_s, int64_t utime);

// Carries PTU_COMMAND to the pan-tilt unit, and each of its positions to PTU_STATE (20 Hz); while
// the unit is not ready, that (10 Hz).
class PtuNode {
 public:
  PtuNode(const PtuConfig& config, messaging::Bus* bus, messaging::PollLoop* loop,
          messaging::HealthReporter* health);

 private:
  void HandleCommand(const sensor::PtuCommand& command);
  void Turn();
  void Publish(double time_s);
  void ReportHealth();

  device::SerialLink link_;
  device::PtuDriver driver_;
  messaging::Bus* bus_;
  messaging::HealthReporter* health_;
  int published_samples_ = 0;
  double published_s_ = 0.0;
  int32_t seq_ = 0;
  std::string said_;  // trouble in the log last
};

}  // namespace geon::ptu
