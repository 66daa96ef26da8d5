#pragma once

#include <string>

#include "device/serial_link.h"
#include "messaging/bus.h"
#include "messaging/health_reporter.h"
#include "messaging/poll_loop.h"
#include "procs/base/base_control.h"

namespace geon::base {

// The one link to the base: puts a BaseControl on the line and on the bus (BASE_STATE, SONAR,
// BUMPER and INFRARED out, BASE_COMMAND and LASER_STATE in). On every way out of the loop the robot
// is stopped.
class BaseNode {
 public:
  BaseNode(const BaseConfig& config, messaging::Bus* bus, messaging::PollLoop* loop,
           messaging::HealthReporter* health);

 private:
  void Turn();
  // Opens the line when due, tells the control of its fate, returns what came.
  std::string ServiceLink(double time_s);
  void Publish();
  void ReportHealth();
  void StopRobot();

  BaseConfig config_;
  device::SerialLink link_;
  BaseControl control_;
  messaging::Bus* bus_;
  messaging::HealthReporter* health_;
  std::string said_;  // trouble in the log last
  sensor::BaseStop said_stop_ = sensor::BaseStop::kNone;
};

}  // namespace geon::base
