#include "messaging/daemon.h"
#include "procs/ptu/ptu_node.h"

int main(int argc, char** argv) {
  constexpr const char* kProcess = "geon-ptu";
  geon::config::DaemonArguments arguments(kProcess, "Drives the pan-tilt unit under the cameras.",
                                          "geon-ptu --port run/ptu.tty");
  std::string port;
  arguments.AddOption("--port", &port, "serial device, instead of the file's ptu.port");
  if (const auto exit_code = arguments.Parse(argc, argv)) return *exit_code;

  const auto config = geon::ptu::LoadPtuConfig(arguments, port);
  if (!config.ok()) return arguments.RefuseConfiguration(config.status());
  if (arguments.check_config) return arguments.AcceptConfiguration();
  return geon::messaging::RunDaemon(
      {{kProcess, geon::config::BuildVersion(), geon::config::FileHash(arguments.config_file)},
       config->bus_url},
      [&](const geon::messaging::Daemon& daemon) {
        const geon::ptu::PtuNode node(*config, daemon.bus, daemon.loop, daemon.health);
        daemon.loop->Run();
        return 0;
      });
}
