#pragma once

#include <memory>

#include "device/frame_source.h"
#include "device/laser_driver.h"
#include "device/serial_link.h"
#include "messaging/bus.h"
#include "messaging/health_reporter.h"
#include "messaging/poll_loop.h"
#include "messaging/rate_limiter.h"
#include "procs/stripe_camera/stripe_camera_config.h"
#include "procs/stripe_camera/stripe_capture.h"
#include "sensor/laser_state.h"

namespace geon::stripe_camera {

// Wires the B/W camera, the laser board and StripeCapture's decisions to the bus. Lasers are off at
// start (the driver's first act), on every way out of the loop, and whenever StripeCapture does not
// want one.
class StripeCameraNode {
 public:
  StripeCameraNode(const StripeCameraConfig& config, std::unique_ptr<device::FrameSource> source,
                   messaging::Bus* bus, messaging::PollLoop* loop,
                   messaging::HealthReporter* health);

 private:
  void ServeLasers();
  void PollSource();
  void PublishAnswers();
  void PublishLaserState();
  void ReportHealth();

  std::unique_ptr<device::FrameSource> source_;
  device::SerialLink link_;
  device::LaserDriver lasers_;
  StripeCapture capture_;
  messaging::Bus* bus_;
  messaging::HealthReporter* health_;
  messaging::RateLimiter troubles_;
  std::string camera_trouble_;
  sensor::LaserState laser_state_;
  int32_t stripe_seq_ = 0;
};

}  // namespace geon::stripe_camera
