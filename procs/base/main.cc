#include <spdlog/spdlog.h>

#include <exception>

#include "messaging/daemon_log.h"
#include "procs/base/base_node.h"

namespace {

constexpr const char* kProcess = "geon-base";

int Run(const geon::base::BaseConfig& config, const std::string& config_hash) {
  geon::messaging::StartLog(kProcess);
  geon::messaging::PollLoop loop;
  auto bus = geon::messaging::Bus::Open({config.bus_url, kProcess});
  if (!bus.ok()) {
    spdlog::error("{}", bus.message());
    return 3;
  }
  geon::messaging::HealthReporter health(bus->get(), &loop,
                                         {kProcess, geon::config::BuildVersion(), config_hash});
  const geon::base::BaseNode node(config, bus->get(), &loop, &health);
  loop.Run();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  geon::config::DaemonArguments arguments(kProcess,
                                          "Drives the Nomad 200 base and reads its sensors.",
                                          "geon-base --port run/base.tty");
  std::string port;
  arguments.app().add_option("--port", port, "serial device, instead of the file's base.port");
  if (const auto exit_code = arguments.Parse(argc, argv)) return *exit_code;

  const auto config = geon::base::LoadBaseConfig(arguments, port);
  if (!config.ok()) return arguments.RefuseConfiguration(config.status());
  if (arguments.check_config) return arguments.AcceptConfiguration();
  try {
    return Run(*config, geon::config::FileHash(arguments.config_file));
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return 1;
  }
}
