#pragma once

#include <string>

#include "base/status.h"
#include "config/daemon_arguments.h"
#include "device/frame_source.h"
#include "device/laser_driver.h"
#include "device/serial_link.h"
#include "geometry/sensor_rig.h"
#include "procs/stripe_camera/stripe_capture.h"

namespace geon::stripe_camera {

struct StripeCameraConfig {
  device::FrameSourceOptions source;  // grey, size: the rig's
  device::SerialLinkOptions lasers;
  device::LaserDriverOptions laser_driver;
  StripeCaptureOptions capture;
  std::string rig_source;  // as drawn, or by which calibration
  std::string bus_url;
};

// Flags that win over the file; empty: the file's value.
struct StripeCameraFlags {
  std::string source;
  std::string lasers;
};

// The `stripe_camera:` section of a robot file (scripts/config/robot.yaml explains every key).
void ReadStripeCameraSection(config::YamlSection section, const geometry::SensorRig& rig,
                             StripeCameraConfig* config);

// Reads `stripe_camera:`, `bus:` and `rig:` of the robot file.
Result<StripeCameraConfig> LoadStripeCameraConfig(const config::DaemonArguments& arguments,
                                                  const StripeCameraFlags& flags);

}  // namespace geon::stripe_camera
