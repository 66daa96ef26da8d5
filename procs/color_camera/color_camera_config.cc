#include "procs/color_camera/color_camera_config.h"

#include <array>

#include "config/bus_config.h"
#include "config/rig_config.h"
#include "procs/color_camera/frame_source_config.h"
#include "procs/color_camera/target_color.h"

namespace geon::color_camera {
namespace {

void ReadExposure(config::YamlSection section, ColorCameraConfig* config) {
  std::string exposure = "target";
  section.ReadOptional("exposure", &exposure);
  section.Check(exposure == "target" || exposure == "fixed", "exposure", "must be target or fixed");
  ExposureControlOptions control;
  std::array<double, 2> range_s = {control.law.least_exposure_s, control.law.most_exposure_s};
  if (section.Has("exposure_range_s")) section.ReadNumbers("exposure_range_s", 2, range_s.data());
  const bool rises = 0.0 < range_s[0] && range_s[0] < range_s[1];
  section.Check(rises, "exposure_range_s", "must be [least, most], above 0 and rising");
  if (exposure != "target" || !rises) return;
  control.law.least_exposure_s = range_s[0];
  control.law.most_exposure_s = range_s[1];
  std::optional<double>& first_s = config->source.controls.exposure_s;
  first_s = control.first_exposure_s = first_s.value_or(control.first_exposure_s);
  config->exposure = control;
}

}  // namespace

void ReadColorCameraSection(config::YamlSection section, Role role, const geometry::SensorRig& rig,
                            ColorCameraConfig* config) {
  config->source =
      ReadFrameSource(section, role == Role::kHead ? rig.color_camera : rig.floor_camera);
  config->source.format = sensor::PixelFormat::kBgr8;
  // The floor camera's stays: obstacles are told by the shade of its first picture.
  if (role == Role::kHead) ReadExposure(section, config);
  section.ReadOptional("max_rate_hz", &config->max_rate_hz);
  section.Check(config->max_rate_hz > 0.0, "max_rate_hz", "must be positive");
  std::string encoding = "raw";
  section.ReadOptional("encoding", &encoding);
  section.Check(encoding == "raw" || encoding == "jpeg", "encoding", "must be raw or jpeg");
  config->encoding = encoding == "jpeg" ? sensor::PixelFormat::kJpeg : sensor::PixelFormat::kBgr8;
  section.ReadOptional("jpeg_quality", &config->jpeg_quality);
  section.Check(config->jpeg_quality >= 1 && config->jpeg_quality <= 100, "jpeg_quality",
                "must be within 1..100");
}

Result<ColorCameraConfig> LoadColorCameraConfig(const config::DaemonArguments& arguments, Role role,
                                                const ColorCameraFlags& flags) {
  const std::string name = role == Role::kHead ? "color_camera" : "floor_camera";
  Result<config::YamlDocument> document =
      config::LoadRobotFile(arguments.config_file, {"bus", "rig", name, "planner"});
  if (!document.ok()) return document.status();
  config::YamlSection root = document->root();

  ColorCameraConfig config;
  config.bus_url = config::ReadBusUrl(arguments, root.Child("bus"));
  const config::RobotRig rig = config::ReadRobotRig(root.Child("rig"), arguments.config_file);
  config.rig_source = rig.source;
  ReadColorCameraSection(root.Child(name), role, rig.rig, &config);
  if (config.exposure) {
    config::YamlSection planner = root.Child("planner");
    ReadTargetColor(planner, arguments.config_file, &config.exposure->target_color);
    for (const std::string& key : planner.Keys()) planner.Ignore(key);
  } else {
    root.Ignore("planner");
  }
  if (Status status = document->Finish(); !status.ok()) return status;

  if (!flags.source.empty()) config.source.source = flags.source;
  if (flags.encoding == "raw") config.encoding = sensor::PixelFormat::kBgr8;
  if (flags.encoding == "jpeg") config.encoding = sensor::PixelFormat::kJpeg;
  return config;
}

}  // namespace geon::color_camera
