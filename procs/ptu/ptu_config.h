#pragma once

#include <string>

#include "base/status.h"
#include "config/daemon_arguments.h"
#include "config/yaml_section.h"
#include "device/ptu_driver.h"
#include "device/serial_link.h"

namespace geon::ptu {

struct PtuConfig {
  device::SerialLinkOptions link;
  device::PtuDriverOptions driver;
  std::string bus_url;
};

// The `ptu:` section of a robot file (scripts/config/robot.yaml explains every key).
void ReadPtuSection(config::YamlSection section, PtuConfig* config);

// Reads `ptu:` and `bus:` of the robot file. A port that is not empty wins over the file's.
Result<PtuConfig> LoadPtuConfig(const config::DaemonArguments& arguments, const std::string& port);

}  // namespace geon::ptu
