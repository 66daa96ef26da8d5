#pragma once

#include <string>

#include "config/daemon_arguments.h"
#include "config/yaml_section.h"

namespace geon::config {

// Where the bus is: --lcm-url, else $LCM_DEFAULT_URL (both in arguments.lcm_url), else `bus: url:`
// of the robot file, which is read, and checked, in any case.
std::string ReadBusUrl(const DaemonArguments& arguments, YamlSection bus);

}  // namespace geon::config
