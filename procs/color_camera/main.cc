#include <spdlog/spdlog.h>

#include <exception>

#include "messaging/channels.h"
#include "messaging/daemon_log.h"
#include "procs/color_camera/color_camera_node.h"

namespace {

using geon::color_camera::ColorCameraConfig;
using geon::color_camera::Role;

int Run(const ColorCameraConfig& config, Role role, const std::string& config_hash) {
  const std::string process =
      role == Role::kHead ? "geon-color-camera-head" : "geon-color-camera-floor";
  geon::messaging::StartLog(process);
  geon::messaging::PollLoop loop;
  auto source = geon::device::OpenFrameSource(config.source);
  if (!source.ok()) {
    spdlog::error("{}", source.message());
    return 2;
  }
  auto bus = geon::messaging::Bus::Open({config.bus_url, process});
  if (!bus.ok()) {
    spdlog::error("{}", bus.message());
    return 3;
  }
  geon::messaging::HealthReporter health(bus->get(), &loop,
                                         {process, geon::config::BuildVersion(), config_hash});
  const auto channel =
      role == Role::kHead ? geon::messaging::kColorImage : geon::messaging::kFloorImage;
  const geon::color_camera::ColorCameraNode node(config, channel, *std::move(source), bus->get(),
                                                 &loop, &health);
  loop.Run();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  geon::config::DaemonArguments arguments(
      "geon-color-camera", "Publishes the frames of the head's or the floor's colour camera.",
      "geon-color-camera --channel head --source v4l2:/dev/video0");
  std::string channel = "head";
  geon::color_camera::ColorCameraFlags flags;
  arguments.app()
      .add_option("--channel", channel, "which camera: head or floor")
      ->check(CLI::IsMember({"head", "floor"}))
      ->capture_default_str();
  arguments.app().add_option("--source", flags.source,
                             "frames from here, not from the file's source");
  arguments.app()
      .add_option("--encoding", flags.encoding, "raw or jpeg, whatever the file says")
      ->check(CLI::IsMember({"raw", "jpeg"}));
  if (const auto exit_code = arguments.Parse(argc, argv)) return *exit_code;

  const Role role = channel == "head" ? Role::kHead : Role::kFloor;
  const auto config = geon::color_camera::LoadColorCameraConfig(arguments, role, flags);
  if (!config.ok()) return arguments.RefuseConfiguration(config.status());
  if (arguments.check_config) return arguments.AcceptConfiguration();
  try {
    return Run(*config, role, geon::config::FileHash(arguments.config_file));
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return 1;
  }
}
