#include <spdlog/spdlog.h>

#include <exception>

#include "messaging/daemon_log.h"
#include "procs/stripe_camera/stripe_camera_node.h"

namespace {

constexpr const char* kProcess = "geon-stripe-camera";

int Run(const geon::stripe_camera::StripeCameraConfig& config, const std::string& config_hash) {
  geon::messaging::StartLog(kProcess);
  geon::messaging::PollLoop loop;
  auto source = geon::device::OpenFrameSource(config.source);
  if (!source.ok()) {
    spdlog::error("{}", source.message());
    return 2;
  }
  auto bus = geon::messaging::Bus::Open({config.bus_url, kProcess});
  if (!bus.ok()) {
    spdlog::error("{}", bus.message());
    return 3;
  }
  geon::messaging::HealthReporter health(bus->get(), &loop,
                                         {kProcess, geon::config::BuildVersion(), config_hash});
  const geon::stripe_camera::StripeCameraNode node(config, *std::move(source), bus->get(), &loop,
                                                   &health);
  loop.Run();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  geon::config::DaemonArguments arguments(
      kProcess, "Lays one laser stripe on request and publishes proven differences of frames.",
      "geon-stripe-camera --source v4l2:/dev/video1 --lasers /dev/ttyUSB0");
  geon::stripe_camera::StripeCameraFlags flags;
  arguments.app().add_option("--source", flags.source,
                             "frames from here, not from the file's source");
  arguments.app().add_option("--lasers", flags.lasers, "laser board here, not at the file's port");
  if (const auto exit_code = arguments.Parse(argc, argv)) return *exit_code;

  const auto config = geon::stripe_camera::LoadStripeCameraConfig(arguments, flags);
  if (!config.ok()) return arguments.RefuseConfiguration(config.status());
  if (arguments.check_config) return arguments.AcceptConfiguration();
  try {
    return Run(*config, geon::config::FileHash(arguments.config_file));
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return 1;
  }
}
