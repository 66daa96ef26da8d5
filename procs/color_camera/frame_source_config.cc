#include "procs/color_camera/frame_source_config.h"

namespace geon::color_camera {
namespace {

device::CameraControls ReadControls(config::YamlSection section) {
  device::CameraControls controls;
  const auto read = [&section](const char* key, auto* target) {
    if (section.Has(key)) section.Read(key, &target->emplace());
  };
  read("exposure_s", &controls.exposure_s);
  read("gain", &controls.gain);
  read("white_balance_k", &controls.white_balance_k);
  read("power_line_hz", &controls.power_line_hz);
  section.Check(controls.exposure_s.value_or(1.0) > 0.0, "exposure_s", "must be positive");
  const int hz = controls.power_line_hz.value_or(0);
  section.Check(hz == 0 || hz == 50 || hz == 60, "power_line_hz", "must be 0, 50 or 60");
  return controls;
}

}  // namespace

device::FrameSourceOptions ReadFrameSource(config::YamlSection section,
                                           const geometry::PinholeCamera& camera) {
  device::FrameSourceOptions options;
  options.width_px = camera.width_px;
  options.height_px = camera.height_px;
  section.Read("source", &options.source);
  section.ReadOptional("timeout_s", &options.timeout_s);
  section.Check(options.timeout_s > 0.0, "timeout_s", "must be positive");
  if (section.Has("controls")) options.controls = ReadControls(section.Child("controls"));
  return options;
}

}  // namespace geon::color_camera
