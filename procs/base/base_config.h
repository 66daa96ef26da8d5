#pragma once

#include <string>

#include "base/status.h"
#include "config/daemon_arguments.h"
#include "config/yaml_section.h"
#include "device/nomad_driver.h"
#include "device/serial_link.h"
#include "procs/base/drive_guard.h"

namespace geon::base {

struct BaseConfig {
  device::SerialLinkOptions link;
  device::NomadDriverOptions driver;
  DriveGuardOptions guard;
  double bumper_zero_rad = 0.0;  // where bumper 0 sits on the base, counter-clockwise from x
  std::string bus_url;
};

// The `base:` section of a robot file (scripts/config/robot.yaml explains every key).
void ReadBaseSection(config::YamlSection section, BaseConfig* config);

// Reads `base:` and `bus:` of the robot file. A port that is not empty wins over the file's.
Result<BaseConfig> LoadBaseConfig(const config::DaemonArguments& arguments,
                                  const std::string& port);

}  // namespace geon::base
