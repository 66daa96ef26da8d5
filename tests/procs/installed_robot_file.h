#pragma once

#include <string>

#include "config/daemon_arguments.h"
#include "config/text_file.h"

namespace geon {

// The text of the robot file, to be read in another folder: the calibrated rig is named in full.
inline std::string InstalledRobotFile() {
  std::string text = config::ReadFile(config::InstalledFile("scripts/config/robot.yaml")).value();
  const std::string rig = "calibration/rig.yaml";
  return text.replace(text.find(rig), rig.size(),
                      config::InstalledFile("scripts/config/calibration/rig.yaml").string());
}

}  // namespace geon
