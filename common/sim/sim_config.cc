#include "sim/sim_config.h"

#include "config/yaml_section.h"

namespace geon::sim {
namespace {

using config::YamlDocument;
using config::YamlSection;

void ReadCamera(YamlSection* root, const std::string& key, CameraOptions* camera) {
  if (!root->Has(key)) return;
  YamlSection section = root->Child(key);
  section.ReadOptional("rate_hz", &camera->rate_hz);
  section.ReadOptional("exposure_us", &camera->exposure_us);
  section.ReadOptional("white_1", &camera->white_1);
  section.ReadOptional("gamma_1", &camera->gamma_1);
  section.ReadOptional("full_well_e", &camera->full_well_e);
  section.ReadOptional("read_noise_e", &camera->read_noise_e);
  section.ReadOptional("black_level_1", &camera->black_level_1);
  section.ReadOptional("blur_1", &camera->blur_1);
  section.ReadOptional("dropped_1", &camera->dropped_1);
}

void ReadLasers(YamlSection* root, LaserOptions* lasers) {
  if (!root->Has("lasers")) return;
  YamlSection section = root->Child("lasers");
  section.ReadOptional("crest_1", &lasers->crest_1);
  section.ReadOptional("waist_sigma_m", &lasers->waist_sigma_m);
  section.ReadOptional("divergence_m", &lasers->divergence_m);
  section.ReadOptionalAngle("fan_half_angle_deg", &lasers->fan_half_angle_rad);
  section.ReadOptional("speckle_1", &lasers->speckle_1);
}

void ReadMounting(YamlSection* root, MountingErrorOptions* mounting) {
  if (!root->Has("mounting")) return;
  YamlSection section = root->Child("mounting");
  section.ReadOptional("focal_1", &mounting->focal_1);
  section.ReadOptional("aspect_1", &mounting->aspect_1);
  section.ReadOptional("principal_px", &mounting->principal_px);
  section.ReadOptional("lens_px", &mounting->lens_px);
  section.ReadOptional("camera_m", &mounting->camera_m);
  section.ReadOptionalAngle("camera_deg", &mounting->camera_rad);
  section.ReadOptional("laser_m", &mounting->laser_m);
  section.ReadOptionalAngle("laser_deg", &mounting->laser_rad);
  section.ReadOptional("laser_bow_1", &mounting->laser_bow_1);
  section.ReadOptional("axes_m", &mounting->axes_m);
  section.ReadOptionalAngle("axes_deg", &mounting->axes_rad);
  section.ReadOptionalAngle("zero_deg", &mounting->zero_rad);
  section.ReadOptional("individual", &mounting->individual);
}

void ReadOdometry(YamlSection* root, SynchroDriveOptions* drive) {
  if (!root->Has("odometry")) return;
  YamlSection section = root->Child("odometry");
  section.ReadOptional("distance_scale_1", &drive->odometry_distance_scale_1);
  section.Check(drive->odometry_distance_scale_1 > 0.5 && drive->odometry_distance_scale_1 < 2.0,
                "distance_scale_1", "must be between 0.5 and 2");
  section.ReadOptional("turn_scale_1", &drive->odometry_turn_scale_1);
  section.Check(drive->odometry_turn_scale_1 > 0.5 && drive->odometry_turn_scale_1 < 2.0,
                "turn_scale_1", "must be between 0.5 and 2");
}

void ReadFaults(YamlSection* faults, const std::string& key, LineFaultOptions* options) {
  if (!faults->Has(key)) return;
  std::string text;
  faults->Read(key, &text);
  const Result<LineFaultOptions> parsed = ParseLineFaults(text);
  faults->Check(parsed.ok(), key, "must be a list of line faults: " + parsed.message());
  if (parsed.ok()) *options = *parsed;
}

Result<SimOptions> Read(const YamlDocument& document) {
  SimOptions options;
  YamlSection root = document.root();
  ReadMounting(&root, &options.renderer.mounting);
  ReadCamera(&root, "color_camera", &options.renderer.color);
  ReadCamera(&root, "stripe_camera", &options.renderer.stripe);
  ReadCamera(&root, "floor_camera", &options.renderer.floor);
  ReadLasers(&root, &options.renderer.lasers);
  ReadOdometry(&root, &options.base.drive);
  if (root.Has("line_faults")) {
    YamlSection faults = root.Child("line_faults");
    ReadFaults(&faults, "ptu", &options.ptu_faults);
    ReadFaults(&faults, "base", &options.base_faults);
    ReadFaults(&faults, "lasers", &options.laser_faults);
  }
  const Status valid = Validate(options.renderer);
  if (!valid.ok()) root.Fail(valid.message());
  const Status status = document.Finish();
  if (!status.ok()) return status;
  return options;
}

}  // namespace

Result<SimOptions> LoadSimOptions(const std::filesystem::path& file) {
  const Result<YamlDocument> document = YamlDocument::Load(file);
  if (!document.ok()) return document.status();
  return Read(*document);
}

Result<SimOptions> ParseSimOptions(const std::string& text, const std::string& name) {
  const Result<YamlDocument> document = YamlDocument::Parse(text, name);
  if (!document.ok()) return document.status();
  return Read(*document);
}

}  // namespace geon::sim
