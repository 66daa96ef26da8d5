#include "sim/camera_options.h"

#include <string>

namespace geon::sim {
namespace {

Status ValidateCamera(const CameraOptions& options) {
  if (!(options.rate_hz > 0.0 && options.rate_hz <= 100.0)) {
    return Status::Error("rate_hz must be above 0 and at most 100");
  }
  if (!(options.exposure_us > 0.0 && options.exposure_us * options.rate_hz <= 0.9e6)) {
    return Status::Error("exposure_us must be positive and leave time to read the frame out");
  }
  if (!(options.white_1 > 0.0)) return Status::Error("white_1 must be positive");
  if (!(options.gamma_1 >= 1.0)) return Status::Error("gamma_1 must be at least 1");
  if (!(options.full_well_e > 0.0)) return Status::Error("full_well_e must be positive");
  if (!(options.read_noise_e >= 0.0)) return Status::Error("read_noise_e must not be negative");
  if (!(options.black_level_1 >= 0.0 && options.black_level_1 < 1.0)) {
    return Status::Error("black_level_1 must be at least 0 and below 1");
  }
  if (!(options.blur_1 >= 0.0 && options.blur_1 <= 1.0 / 3.0)) {
    return Status::Error("blur_1 must be between 0 and 1/3");
  }
  if (!(options.dropped_1 >= 0.0 && options.dropped_1 <= 1.0)) {
    return Status::Error("dropped_1 must be between 0 and 1");
  }
  return Status::Ok();
}

}  // namespace

Status Validate(const RendererOptions& options) {
  const struct {
    const CameraOptions* camera;
    const char* name;
  } cameras[] = {{&options.color, "color_camera"},
                 {&options.stripe, "stripe_camera"},
                 {&options.floor, "floor_camera"}};
  for (const auto& [camera, name] : cameras) {
    const Status status = ValidateCamera(*camera);
    if (!status.ok()) return status.In(name);
  }
  const LaserOptions& lasers = options.lasers;
  if (!(lasers.crest_1 > 0.0)) return Status::Error("lasers: crest_1 must be positive");
  if (!(lasers.waist_sigma_m > 0.0)) return Status::Error("lasers: waist_sigma_m must be positive");
  if (!(lasers.divergence_m > 0.0)) return Status::Error("lasers: divergence_m must be positive");
  if (!(lasers.fan_half_angle_rad > 0.0 && lasers.fan_half_angle_rad < kPi / 2)) {
    return Status::Error("lasers: fan_half_angle_deg must be between 0 and 90");
  }
  if (!(lasers.speckle_1 >= 0.0)) return Status::Error("lasers: speckle_1 must not be negative");
  const MountingErrorOptions& mounting = options.mounting;
  for (const double sigma :
       {mounting.focal_1, mounting.aspect_1, mounting.principal_px, mounting.lens_px,
        mounting.camera_m, mounting.camera_rad, mounting.laser_m, mounting.laser_rad,
        mounting.laser_bow_1, mounting.axes_m, mounting.axes_rad, mounting.zero_rad}) {
    if (!(sigma >= 0.0)) {
      return Status::Error("mounting: standard deviations must not be negative");
    }
  }
  if (!(mounting.lens_px <= 10.0)) return Status::Error("mounting: lens_px must be at most 10");
  return Status::Ok();
}

}  // namespace geon::sim
