#include <spdlog/spdlog.h>

#include "messaging/daemon.h"
#include "procs/stripe_camera/stripe_camera_node.h"

namespace {

int Serve(const geon::stripe_camera::StripeCameraConfig& config,
          const geon::messaging::Daemon& daemon) {
  auto source = geon::device::OpenFrameSource(config.source);
  if (!source.ok()) {
    spdlog::error("{}", source.message());
    return 2;
  }
  spdlog::info("the rig is taken {}", config.rig_source);
  const geon::stripe_camera::StripeCameraNode node(config, *std::move(source), daemon.bus,
                                                   daemon.loop, daemon.health);
  daemon.loop->Run();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr const char* kProcess = "geon-stripe-camera";
  geon::config::DaemonArguments arguments(
      kProcess, "Lays one laser stripe on request and publishes proven differences of frames.",
      "geon-stripe-camera --source v4l2:/dev/video1 --lasers /dev/ttyUSB0");
  geon::stripe_camera::StripeCameraFlags flags;
  arguments.AddOption("--source", &flags.source, "frames from here, not from the file's source");
  arguments.AddOption("--lasers", &flags.lasers, "laser board here, not at the file's port");
  if (const auto exit_code = arguments.Parse(argc, argv)) return *exit_code;

  const auto config = geon::stripe_camera::LoadStripeCameraConfig(arguments, flags);
  if (!config.ok()) return arguments.RefuseConfiguration(config.status());
  if (arguments.check_config) return arguments.AcceptConfiguration();
  return geon::messaging::RunDaemon(
      {{kProcess, geon::config::BuildVersion(), geon::config::FileHash(arguments.config_file)},
       config->bus_url},
      [&](const geon::messaging::Daemon& daemon) { return Serve(*config, daemon); });
}
