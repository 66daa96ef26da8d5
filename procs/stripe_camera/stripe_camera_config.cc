#include "procs/stripe_camera/stripe_camera_config.h"

#include "config/bus_config.h"
#include "config/rig_config.h"
#include "procs/color_camera/frame_source_config.h"

namespace geon::stripe_camera {
namespace {

void ReadSeconds(config::YamlSection* section, const char* key, double* value_s) {
  section->ReadOptional(key, value_s);
  section->Check(*value_s >= 0.0, key, "must not be negative");
}

void ReadCount(config::YamlSection* section, const char* key, int* value) {
  section->ReadOptional(key, value);
  section->Check(*value >= 1, key, "must be at least 1");
}

void ReadProof(config::YamlSection section, StripeProofOptions* proof) {
  section.ReadOptional("min_peak_level", &proof->min_peak_level);
  section.Check(proof->min_peak_level > 0.0 && proof->min_peak_level < 255.0, "min_peak_level",
                "must be within 0..255");
  section.ReadOptional("min_peak_to_noise_1", &proof->min_peak_to_noise_1);
  section.Check(proof->min_peak_to_noise_1 > 0.0, "min_peak_to_noise_1", "must be positive");
  ReadCount(&section, "min_lit_lines", &proof->min_lit_lines);
}

void ReadCapture(config::YamlSection section, StripeCaptureOptions* capture) {
  ReadCount(&section, "frames_per_stripe", &capture->frames_per_stripe);
  ReadCount(&section, "lit_tries", &capture->lit_tries);
  ReadSeconds(&section, "settle_s", &capture->settle_s);
  ReadSeconds(&section, "still_s", &capture->still_s);
  ReadSeconds(&section, "request_timeout_s", &capture->request_timeout_s);
  if (section.Has("proof")) ReadProof(section.Child("proof"), &capture->proof);
}

}  // namespace

void ReadStripeCameraSection(config::YamlSection section, const geometry::SensorRig& rig,
                             StripeCameraConfig* config) {
  config->source = color_camera::ReadFrameSource(section, rig.stripe_camera);
  config->source.format = sensor::PixelFormat::kGray8;
  config::YamlSection lasers = section.Child("lasers");
  lasers.Read("port", &config->lasers.path);
  config->lasers.baud = 115200;
  lasers.ReadOptional("baud", &config->lasers.baud);
  ReadSeconds(&lasers, "reply_timeout_s", &config->laser_driver.reply_timeout_s);
  ReadCapture(section, &config->capture);
  if (config->source.controls.exposure_s) {
    config->capture.exposure_s = *config->source.controls.exposure_s;
  }
}

Result<StripeCameraConfig> LoadStripeCameraConfig(const config::DaemonArguments& arguments,
                                                  const StripeCameraFlags& flags) {
  Result<config::YamlDocument> document =
      config::LoadRobotFile(arguments.config_file, {"bus", "rig", "stripe_camera"});
  if (!document.ok()) return document.status();
  config::YamlSection root = document->root();

  StripeCameraConfig config;
  config.bus_url = config::ReadBusUrl(arguments, root.Child("bus"));
  const config::RobotRig rig = config::ReadRobotRig(root.Child("rig"), arguments.config_file);
  config.rig_source = rig.source;
  ReadStripeCameraSection(root.Child("stripe_camera"), rig.rig, &config);
  if (Status status = document->Finish(); !status.ok()) return status;

  if (!flags.source.empty()) config.source.source = flags.source;
  if (!flags.lasers.empty()) config.lasers.path = flags.lasers;
  return config;
}

}  // namespace geon::stripe_camera
