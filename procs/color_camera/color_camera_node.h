#pragma once

#include <memory>
#include <optional>
#include <string>

#include "device/frame_source.h"
#include "messaging/bus.h"
#include "messaging/health_reporter.h"
#include "messaging/poll_loop.h"
#include "messaging/rate_limiter.h"
#include "procs/color_camera/color_camera_config.h"

namespace geon::color_camera {

// Carries the newest frame of one camera to one channel, and sets the camera's exposure by what the
// frames show where the configuration says so; frames in which a laser may have burned do not
// count. The published images are numbered anew, so that a hole in seq is a loss on the bus; utime
// is the camera's.
class ColorCameraNode {
 public:
  ColorCameraNode(const ColorCameraConfig& config, std::string_view channel,
                  std::unique_ptr<device::FrameSource> source, messaging::Bus* bus,
                  messaging::PollLoop* loop, messaging::HealthReporter* health);

 private:
  void PollSource();
  void FollowLasers(messaging::PollLoop* loop);
  void ControlExposure(const sensor::Image& image);
  void ReportHealth();
  void Publish(sensor::Image image);

  ColorCameraConfig config_;
  std::string channel_;
  std::unique_ptr<device::FrameSource> source_;
  messaging::Bus* bus_;
  messaging::HealthReporter* health_;
  messaging::RateLimiter troubles_;
  std::optional<ExposureControl> exposure_;
  std::string exposure_trouble_;
  bool laser_burns_ = false;
  int64_t dark_from_utime_ = 0;  // since then no laser has burned
  std::string warned_;
  int64_t last_utime_ = 0;
  int32_t seq_ = 0;
};

}  // namespace geon::color_camera
