#include <spdlog/spdlog.h>

#include "messaging/channels.h"
#include "messaging/daemon.h"
#include "procs/color_camera/color_camera_node.h"

namespace {

using geon::color_camera::ColorCameraConfig;
using geon::color_camera::Role;

int Serve(const ColorCameraConfig& config, Role role, const geon::messaging::Daemon& daemon) {
  auto source = geon::device::OpenFrameSource(config.source);
  if (!source.ok()) {
    spdlog::error("{}", source.message());
    return 2;
  }
  spdlog::info("the rig is taken {}", config.rig_source);
  const auto channel =
      role == Role::kHead ? geon::messaging::kColorImage : geon::messaging::kFloorImage;
  const geon::color_camera::ColorCameraNode node(config, channel, *std::move(source), daemon.bus,
                                                 daemon.loop, daemon.health);
  daemon.loop->Run();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  geon::config::DaemonArguments arguments(
      "geon-color-camera", "Publishes the frames of the head's or the floor's colour camera.",
      "geon-color-camera --channel head --source v4l2:/dev/video0");
  std::string channel = "head";
  geon::color_camera::ColorCameraFlags flags;
  arguments.AddChoice("--channel", &channel, {"head", "floor"}, "which camera: head or floor");
  arguments.AddOption("--source", &flags.source, "frames from here, not from the file's source");
  arguments.AddChoice("--encoding", &flags.encoding, {"raw", "jpeg"},
                      "raw or jpeg, whatever the file says");
  if (const auto exit_code = arguments.Parse(argc, argv)) return *exit_code;

  const Role role = channel == "head" ? Role::kHead : Role::kFloor;
  const auto config = geon::color_camera::LoadColorCameraConfig(arguments, role, flags);
  if (!config.ok()) return arguments.RefuseConfiguration(config.status());
  if (arguments.check_config) return arguments.AcceptConfiguration();
  return geon::messaging::RunDaemon(
      {{"geon-color-camera-" + channel, geon::config::BuildVersion(),
        geon::config::FileHash(arguments.config_file)},
       config->bus_url},
      [&](const geon::messaging::Daemon& daemon) { return Serve(*config, role, daemon); });
}
