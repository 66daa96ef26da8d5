#include <spdlog/spdlog.h>

#include "messaging/daemon.h"
#include "procs/recognizer/recognizer_config.h"
#include "procs/recognizer/recognizer_node.h"

namespace {

int Serve(const geon::recognizer::RecognizerConfig& config, const geon::messaging::Daemon& daemon) {
  const auto calibration = geon::recognizer::LoadCalibration(config);
  if (!calibration.ok()) {
    spdlog::error("{}", calibration.message());
    return 3;
  }
  spdlog::info("the rig is taken {}", config.rig_source);
  daemon.health->SetCalibration(geon::recognizer::CalibrationHash(config, *calibration),
                                *calibration ? (*calibration)->directory : config.rig_source);
  const geon::recognizer::RecognizerNode node({config.rig, *calibration, config.assembler},
                                              daemon.bus, daemon.health);
  daemon.loop->Watch(daemon.bus->file_descriptor(), [&] { daemon.bus->HandlePending(); });
  daemon.loop->Run();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr const char* kProcess = "geon-recognizer";
  geon::config::DaemonArguments arguments(
      kProcess, "Turns stripes into range profiles and a complete scan into a verdict.",
      "geon-recognizer --calibration run/calibration");
  std::string calibration;
  arguments.AddOption("--calibration", &calibration,
                      "folder of look-up tables to range by, instead of recognizer.ranging");
  if (const auto exit_code = arguments.Parse(argc, argv)) return *exit_code;

  const auto config = geon::recognizer::LoadRecognizerConfig(arguments, calibration);
  if (!config.ok()) return arguments.RefuseConfiguration(config.status());
  if (arguments.check_config) return arguments.AcceptConfiguration();
  return geon::messaging::RunDaemon(
      {{kProcess, geon::config::BuildVersion(), geon::config::FileHash(arguments.config_file)},
       config->bus_url},
      [&](const geon::messaging::Daemon& daemon) { return Serve(*config, daemon); });
}
