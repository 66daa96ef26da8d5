#include <spdlog/spdlog.h>

#include <exception>

#include "messaging/daemon_log.h"
#include "messaging/poll_loop.h"
#include "procs/recognizer/recognizer_config.h"
#include "procs/recognizer/recognizer_node.h"

namespace {

constexpr const char* kProcess = "geon-recognizer";

int Run(const geon::recognizer::RecognizerConfig& config, const std::string& config_hash) {
  geon::messaging::StartLog(kProcess);
  auto calibration = geon::recognizer::LoadStripeCalibration(config.calibration_dir, config.rig);
  if (!calibration.ok()) {
    spdlog::error("{}", calibration.message());
    return 3;
  }
  geon::messaging::PollLoop loop;
  auto bus = geon::messaging::Bus::Open({config.bus_url, kProcess});
  if (!bus.ok()) {
    spdlog::error("{}", bus.message());
    return 3;
  }
  geon::messaging::HealthReporter health(bus->get(), &loop,
                                         {kProcess, geon::config::BuildVersion(), config_hash});
  health.SetCalibration(calibration->hash, calibration->directory);
  const geon::recognizer::RecognizerNode node({config.rig, *calibration, config.assembler},
                                              bus->get(), &health);
  loop.Watch((*bus)->file_descriptor(), [&bus] { (*bus)->HandlePending(); });
  loop.Run();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  geon::config::DaemonArguments arguments(
      kProcess, "Turns stripes into range profiles and a complete scan into a verdict.",
      "geon-recognizer --calibration run/calibration");
  std::string calibration;
  arguments.app().add_option("--calibration", calibration,
                             "folder of the look-up tables, instead of recognizer.calibration_dir");
  if (const auto exit_code = arguments.Parse(argc, argv)) return *exit_code;

  const auto config = geon::recognizer::LoadRecognizerConfig(arguments, calibration);
  if (!config.ok()) return arguments.RefuseConfiguration(config.status());
  if (arguments.check_config) return arguments.AcceptConfiguration();
  try {
    return Run(*config, geon::config::FileHash(arguments.config_file));
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return 1;
  }
}
