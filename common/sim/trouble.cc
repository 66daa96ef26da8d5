#include "sim/trouble.h"

#include <Eigen/Geometry>

#include "sim/noise_source.h"

namespace geon::sim {
namespace {

double Around(double middle, double at_most, NoiseSource* noise) {
  return noise->Uniform(middle - at_most, middle + at_most);
}

void LightTheRoom(NoiseSource* noise, Lighting* light) {
  // Even in the inverse of the temperature: equal steps of that look equal.
  light->kelvin = 1.0 / noise->Uniform(1.0 / kColdest_kelvin, 1.0 / kWarmest_kelvin);
  light->level_1 = noise->Uniform(kDimmest_1, kBrightest_1);
  const bool sunny = noise->Chance(kSunnyRuns_1);
  const double level_1 = noise->Uniform(kFaintestSun_1, kStrongestSun_1);
  light->sun.level_1 = sunny ? level_1 : 0.0;
  light->sun.azimuth_rad = noise->Uniform(0.0, 2.0 * kPi);
  light->sun.elevation_rad = noise->Uniform(kLowestSun_rad, kHighestSun_rad);
}

// Hue turns about the axis of the greys, saturation is the distance from it.
Eigen::Vector3d OtherTin(const Eigen::Vector3d& color_rgb, NoiseSource* noise) {
  const Eigen::Vector3d grey_rgb = Eigen::Vector3d::Constant(color_rgb.mean());
  const double hue_rad = Around(0.0, kPaintHue_rad, noise);
  const double saturation_1 = Around(1.0, kPaintSaturation_1, noise);
  const double value_1 = Around(1.0, kPaintValue_1, noise);
  const Eigen::AngleAxisd turn(hue_rad, Eigen::Vector3d::Ones().normalized());
  const Eigen::Vector3d other_rgb =
      value_1 * (grey_rgb + saturation_1 * (turn * (color_rgb - grey_rgb)));
  return other_rgb.cwiseMax(0.0).cwiseMin(255.0);
}

}  // namespace

void AddTrouble(uint64_t seed, World* world, SimOptions* options) {
  NoiseSource noise(seed ^ 0x74726f75626c65ULL);
  SynchroDriveOptions& drive = options->base.drive;
  drive.odometry_distance_scale_1 = Around(1.0, kOdometryDrift_1, &noise);
  drive.odometry_turn_scale_1 = Around(1.0, kOdometryDrift_1, &noise);
  world->groove_tilt_rad = noise.Uniform(0.0, kMostTilt_rad);
  LightTheRoom(&noise, &world->lighting);
  const bool glossy = noise.Chance(kGlossyRuns_1);
  const double gloss_1 = noise.Uniform(kLeastGloss_1, kMostGloss_1);
  world->floor_gloss_1 = glossy ? gloss_1 : 0.0;
  RendererOptions& cameras = options->renderer;
  for (CameraOptions* camera : {&cameras.color, &cameras.stripe, &cameras.floor}) {
    camera->dropped_1 = noise.Uniform(0.0, kMostDropped_1);
  }
  for (WorldObject& object : world->objects) {
    if (IsTarget(object)) object.color_rgb = OtherTin(object.color_rgb, &noise);
  }
}

}  // namespace geon::sim
