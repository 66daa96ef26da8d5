#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/status.h"
#include "config/daemon_arguments.h"
#include "config/yaml_section.h"
#include "device/frame_source.h"
#include "geometry/sensor_rig.h"
#include "procs/color_camera/exposure_control.h"
#include "sensor/image.h"

namespace geon::color_camera {

// Which of the two colour cameras a process serves.
enum class Role { kHead, kFloor };

struct ColorCameraConfig {
  device::FrameSourceOptions source;               // size: the rig's
  std::optional<ExposureControlOptions> exposure;  // nothing: fixed
  double max_rate_hz = 10.0;                       // frames that come faster are left out
  sensor::PixelFormat encoding = sensor::PixelFormat::kBgr8;  // or kJpeg
  int jpeg_quality = 90;
  std::string rig_source;  // as drawn, or by which calibration
  std::string bus_url;
};

// Flags that win over the file; empty: the file's value.
struct ColorCameraFlags {
  std::string source;
  std::string encoding;
};

// Reads all keys of the section of one camera; the target's colour is the planner's section's.
// Errors go to the section's document.
void ReadColorCameraSection(config::YamlSection section, Role role, const geometry::SensorRig& rig,
                            ColorCameraConfig* config);

// Reads `color_camera:` or `floor_camera:`, and `bus:`, `rig:` and, to expose for the
// target, its colour in `planner:` of the robot file.
Result<ColorCameraConfig> LoadColorCameraConfig(const config::DaemonArguments& arguments, Role role,
                                                const ColorCameraFlags& flags);

}  // namespace geon::color_camera
