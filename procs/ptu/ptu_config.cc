#include "procs/ptu/ptu_config.h"

#include "config/bus_config.h"

namespace geon::ptu {

void ReadPtuSection(config::YamlSection section, PtuConfig* config) {
  section.Read("port", &config->link.path);
  section.Check(!config->link.path.empty(), "port", "must name a serial device");
  section.Read("baud", &config->link.baud);
  section.Check(config->link.baud >= 4800 && config->link.baud <= 230400, "baud",
                "must be 4800 ... 230400; the unit's own is 9600");
  section.ReadAngle("speed_deg_s", &config->driver.speed_rad_s);
  section.Check(config->driver.speed_rad_s > 0.0 && config->driver.speed_rad_s <= 5.3,
                "speed_deg_s", "must be above 0 and at most 300");
  section.Read("reset_at_start", &config->driver.reset_at_start);
}

Result<PtuConfig> LoadPtuConfig(const config::DaemonArguments& arguments, const std::string& port) {
  Result<config::YamlDocument> document =
      config::LoadRobotFile(arguments.config_file, {"ptu", "bus"});
  if (!document.ok()) return document.status();
  PtuConfig config;
  ReadPtuSection(document->root().Child("ptu"), &config);
  config.bus_url = config::ReadBusUrl(arguments, document->root().Child("bus"));
  const Status status = document->Finish();
  if (!status.ok()) return status;
  if (!port.empty()) config.link.path = port;
  return config;
}

}  // namespace geon::ptu
