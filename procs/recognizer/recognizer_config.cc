#include "procs/recognizer/recognizer_config.h"

#include "config/bus_config.h"
#include "config/rig_config.h"

namespace geon::recognizer {
namespace {

// `arguments` only where the bus is wanted.
Result<RecognizerConfig> Load(const std::filesystem::path& robot_file,
                              const std::string& calibration_dir,
                              const config::DaemonArguments* arguments) {
  std::vector<std::string> sections = {"rig", "recognizer"};
  if (arguments != nullptr) sections.emplace_back("bus");
  Result<config::YamlDocument> document = config::LoadRobotFile(robot_file, sections);
  if (!document.ok()) return document.status();
  RecognizerConfig config;
  const config::RobotRig rig = config::ReadRobotRig(document->root().Child("rig"), robot_file);
  config.rig = rig.rig;
  config.rig_source = rig.source;
  config.rig_hash = rig.hash;
  ReadRecognizerSection(document->root().Child("recognizer"), &config);
  if (arguments != nullptr) {
    config.bus_url = config::ReadBusUrl(*arguments, document->root().Child("bus"));
  }
  if (const Status status = document->Finish(); !status.ok()) return status;
  if (config.calibration_dir.is_relative()) {
    config.calibration_dir = robot_file.parent_path() / config.calibration_dir;
  }
  if (!calibration_dir.empty()) {
    config.calibration_dir = calibration_dir;
    config.ranging = Ranging::kLookUpTable;
  }
  return config;
}

}  // namespace

void ReadRecognizerSection(config::YamlSection section, RecognizerConfig* config) {
  std::string calibration_dir;
  section.Read("calibration_dir", &calibration_dir);
  section.Check(!calibration_dir.empty(), "calibration_dir", "must name a folder");
  config->calibration_dir = calibration_dir;

  std::string name = "lut";
  section.ReadOptional("ranging", &name);
  section.Check(name == "lut" || name == "rig", "ranging", "must be lut or rig");
  config->ranging = name == "rig" ? Ranging::kRig : Ranging::kLookUpTable;

  section.Read("method", &name);
  const auto method = recognition::MethodFromString(name);
  section.Check(method.has_value(), "method", "must be evidence or thesis");
  if (method) config->assembler.recognition.method = *method;

  section.Read("curvature", &name);
  const auto curvature = recognition::CurvatureMethodFromString(name);
  section.Check(curvature.has_value(), "curvature", "must be ogorman, ramer or wall");
  if (curvature) config->assembler.recognition.curvature = *curvature;

  section.Read("smoothing", &name);
  const auto smoothing = recognition::SmoothingFromString(name);
  section.Check(smoothing.has_value(), "smoothing", "must be median, gaussian or none");
  if (smoothing) config->assembler.recognition.smoothing.kind = *smoothing;

  section.Read("fewest_points", &config->assembler.fewest_points);
  section.Check(config->assembler.fewest_points >= 1, "fewest_points", "must be at least 1");
}

Result<RecognizerConfig> LoadRecognizerConfig(const std::filesystem::path& robot_file,
                                              const std::string& calibration_dir) {
  return Load(robot_file, calibration_dir, nullptr);
}

std::string CalibrationHash(const RecognizerConfig& config,
                            const std::optional<StripeCalibration>& tables) {
  return tables ? tables->hash : config.rig_hash;
}

Result<std::optional<StripeCalibration>> LoadCalibration(const RecognizerConfig& config) {
  if (config.ranging == Ranging::kRig) return std::optional<StripeCalibration>();
  Result<StripeCalibration> calibration = LoadStripeCalibration(config.calibration_dir, config.rig);
  if (!calibration.ok()) return calibration.status();
  return std::optional<StripeCalibration>(std::move(*calibration));
}

Result<RecognizerConfig> LoadRecognizerConfig(const config::DaemonArguments& arguments,
                                              const std::string& calibration_dir) {
  return Load(arguments.config_file, calibration_dir, &arguments);
}

}  // namespace geon::recognizer
