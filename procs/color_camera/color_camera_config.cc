#include "procs/color_camera/color_camera_config.h"

#include "config/bus_config.h"
#include "config/rig_config.h"
#include "procs/color_camera/frame_source_config.h"

namespace geon::color_camera {
Result<ColorCameraConfig> LoadColorCameraConfig(const config::DaemonArguments& arguments, Role role,
                                                const ColorCameraFlags& flags) {
  const std::string name = role == Role::kHead ? "color_camera" : "floor_camera";
  Result<config::YamlDocument> document =
      config::LoadRobotFile(arguments.config_file, {"bus", "rig", name});
  if (!document.ok()) return document.status();
  config::YamlSection root = document->root();

  ColorCameraConfig config;
  config.bus_url = config::ReadBusUrl(arguments, root.Child("bus"));
  const config::RobotRig rig = config::ReadRobotRig(root.Child("rig"), arguments.config_file);
  config.rig_source = rig.source;
  config::YamlSection section = root.Child(name);
  config.source =
      ReadFrameSource(section, role == Role::kHead ? rig.rig.color_camera : rig.rig.floor_camera);
  config.source.format = sensor::PixelFormat::kBgr8;
  section.ReadOptional("max_rate_hz", &config.max_rate_hz);
  section.Check(config.max_rate_hz > 0.0, "max_rate_hz", "must be positive");
  std::string encoding = "raw";
  section.ReadOptional("encoding", &encoding);
  section.Check(encoding == "raw" || encoding == "jpeg", "encoding", "must be raw or jpeg");
  section.ReadOptional("jpeg_quality", &config.jpeg_quality);
  section.Check(config.jpeg_quality >= 1 && config.jpeg_quality <= 100, "jpeg_quality",
                "must be within 1..100");
  if (Status status = document->Finish(); !status.ok()) return status;

  if (!flags.source.empty()) config.source.source = flags.source;
  if (!flags.encoding.empty()) encoding = flags.encoding;
  config.encoding = encoding == "jpeg" ? sensor::PixelFormat::kJpeg : sensor::PixelFormat::kBgr8;
  return config;
}

}  // namespace geon::color_camera
