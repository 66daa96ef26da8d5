#pragma once

#include <string>

#include "base/status.h"
#include "config/daemon_arguments.h"
#include "config/yaml_section.h"
#include "geometry/sensor_rig.h"
#include "mission/mission_options.h"

namespace geon::planner {

struct PlannerConfig {
  mission::MissionOptions mission;
  geometry::SensorRig rig;
  std::string rig_source;  // as drawn, or by which calibration
  std::string bus_url;
};

// The `planner:` section of a robot file (scripts/config/robot.yaml explains every key). A colour
// model file is looked for beside the robot file.
void ReadPlannerSection(config::YamlSection section, const std::filesystem::path& robot_file,
                        mission::MissionOptions* options);

// Reads `planner:`, `rig:` and `bus:` of the robot file. `to` is what --to says, "X,Y" in metres in
// place of the file's destination; empty: the file's.
Result<PlannerConfig> LoadPlannerConfig(const config::DaemonArguments& arguments,
                                        const std::string& to = "");

}  // namespace geon::planner
