#pragma once

#include <filesystem>
#include <string>

#include "config/yaml_section.h"
#include "geometry/sensor_rig.h"

namespace geon::config {

// Reads the `rig:` section of a robot file (scripts/config/robot.yaml explains every key): the head
// as designed (thesis sections 3.1-3.3). Errors go to the section's document. Only who builds or
// calibrates a robot asks for the drawing.
geometry::SensorRig ReadDrawnRig(YamlSection rig);

// The rig to work with: the calibrated one where the section names its file (`calibrated:`,
// relative to the robot file), else the drawing.
struct RobotRig {
  geometry::SensorRig rig;
  std::string source = "as drawn";  // or "calibrated 2026-11-22 (FILE)", for logs
  std::string hash;                 // of the calibration's file; empty: as drawn
};

// As ReadDrawnRig; a calibration that is missing, damaged or not of this drawing is an error too.
RobotRig ReadRobotRig(YamlSection rig, const std::filesystem::path& robot_file);

}  // namespace geon::config
