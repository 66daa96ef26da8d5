#pragma once

#include "config/yaml_section.h"
#include "geometry/sensor_rig.h"

namespace geon::config {

// Reads the `rig:` section of a robot file (scripts/config/robot.yaml explains every key): the head
// as designed (thesis sections 3.1-3.3). Errors go to the section's document.
geometry::SensorRig ReadSensorRig(YamlSection rig);

}  // namespace geon::config
