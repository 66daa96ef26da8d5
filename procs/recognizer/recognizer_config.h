#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/status.h"
#include "config/daemon_arguments.h"
#include "config/yaml_section.h"
#include "geometry/sensor_rig.h"
#include "procs/recognizer/scan_assembler.h"

namespace geon::recognizer {

struct RecognizerConfig {
  geometry::SensorRig rig;
  std::string rig_source;  // as drawn, or by which calibration
  std::string rig_hash;    // of that calibration
  std::filesystem::path calibration_dir;
  Ranging ranging = Ranging::kLookUpTable;
  ScanAssemblerOptions assembler;
  std::string bus_url;
};

// The `recognizer:` section of a robot file (scripts/config/robot.yaml explains every key).
void ReadRecognizerSection(config::YamlSection section, RecognizerConfig* config);

// Reads `rig:` and `recognizer:` of a robot file; a relative calibration_dir belongs to the folder
// of that file. `calibration_dir`, when not empty: distances come from the tables there.
Result<RecognizerConfig> LoadRecognizerConfig(const std::filesystem::path& robot_file,
                                              const std::string& calibration_dir);

// The hash of what distances come from: of the tables, or of the rig's calibration; empty when the
// rig is as drawn.
std::string CalibrationHash(const RecognizerConfig& config,
                            const std::optional<StripeCalibration>& tables);

// The look-up tables, or none if distances come from the rig.
Result<std::optional<StripeCalibration>> LoadCalibration(const RecognizerConfig& config);

// The same with `bus:`, for the daemon.
Result<RecognizerConfig> LoadRecognizerConfig(const config::DaemonArguments& arguments,
                                              const std::string& calibration_dir);

}  // namespace geon::recognizer
