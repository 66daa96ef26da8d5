#include "sim/color_trial.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"
#include "sim/hash_noise.h"
#include "sim/image_sensor.h"
#include "sim/noise_source.h"
#include "sim/shading.h"
#include "sim/view.h"
#include "sim/world_scene.h"

namespace geon::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kSunLevel_1 = 3.0;  // of the lamp's
const Vector3d kTargetColor_rgb(150.0, 40.0, 40.0);

Vector2d Direction(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

geons::GeonShape TargetShape(GeonLabel label, NoiseSource* noise) {
  geons::GeonShape shape;
  shape.label = label;
  for (int axis = 0; axis < 3; ++axis) shape.size_m[axis] = noise->Uniform(0.12, 0.26);
  if (geons::IsRound(label) && label != GeonLabel::kEllipsoid) shape.size_m.y() = shape.size_m.x();
  if (geons::IsTapered(label)) shape.taper_1 = noise->Uniform(0.25, 0.6);
  if (geons::IsBent(label)) {
    const double thickness_m = noise->Uniform(0.07, 0.10);
    shape.size_m = {thickness_m, thickness_m, noise->Uniform(0.24, 0.34)};
    shape.bend_rad = RadiansFromDegrees(noise->Uniform(70.0, 150.0));
  }
  const auto positions = static_cast<uint64_t>(geons::StablePositionCount(label));
  shape.position = 1 + static_cast<int>(noise->Bits() % positions);
  return shape;
}

// Hue 0 is red, 60 yellow, 300 magenta.
Vector3d ColorOf(double hue_deg, double saturation_1, double value) {
  Vector3d rgb;
  for (int channel = 0; channel < 3; ++channel) {
    const double k = std::fmod((5.0 - 2.0 * channel) + hue_deg / 60.0, 6.0);
    rgb[channel] = value * (1.0 - saturation_1 * std::max(0.0, std::min({k, 4.0 - k, 1.0})));
  }
  return rgb;
}

// Brown, orange, pink, maroon: somewhere within what people call so.
Vector3d ReddishColor(int kind, NoiseSource* noise) {
  const auto draw = [noise](double low, double high) { return noise->Uniform(low, high); };
  const double first = draw(0.0, 1.0), second = draw(0.0, 1.0), third = draw(0.0, 1.0);
  const auto between = [](double low, double high, double share_1) {
    return low + (high - low) * share_1;
  };
  switch (kind) {
    case 0:
      return ColorOf(between(18, 30, first), between(0.45, 0.6, second), between(80, 130, third));
    case 1:
      return ColorOf(between(22, 34, first), between(0.75, 0.9, second), between(180, 230, third));
    case 2:
      return ColorOf(between(335, 350, first), between(0.3, 0.45, second),
                     between(180, 230, third));
    default:
      return ColorOf(between(335, 350, first), between(0.45, 0.6, second), between(80, 110, third));
  }
}

// What a trial is built around: the target's place, and where the camera looks from.
struct Stage {
  Vector2d target_m;
  double foot_m = 0.0;
  double camera_rad = 0.0;  // direction from the target to the camera, seen from above

  Vector2d At(double towards_camera_m, double to_its_right_m) const {
    const Vector2d ahead = Direction(camera_rad);
    return target_m + towards_camera_m * ahead + to_its_right_m * Vector2d(-ahead.y(), ahead.x());
  }
};

void AddBox(const Vector2d& place_m, double foot_m, const Vector3d& size_m, double yaw_rad,
            const Vector3d& color_rgb, World* world) {
  WorldObject box;
  box.shape = BoxShape{size_m};
  box.x_m = place_m.x();
  box.y_m = place_m.y();
  box.z_m = foot_m;
  box.yaw_rad = yaw_rad;
  box.color_rgb = color_rgb;
  world->objects.push_back(box);
}

// Things beside and behind the target, none of them before it.
void AddClutter(const Stage& stage, bool reddish, NoiseSource* noise, World* world) {
  constexpr int kThings = 4;
  for (int kind = 0; kind < kThings; ++kind) {
    const double side = (kind % 2 == 0) ? 1.0 : -1.0;
    const Vector2d place_m = stage.At(-noise->Uniform(0.0, 0.7), side * noise->Uniform(0.38, 0.75));
    Vector3d size_m;
    for (int axis = 0; axis < 3; ++axis) size_m[axis] = noise->Uniform(0.15, 0.3);
    const double yaw_rad = noise->Uniform(0.0, 2.0 * kPi);
    const double grey = noise->Uniform(60.0, 180.0), blueness = noise->Uniform(0.0, 40.0);
    const Vector3d color_rgb =
        reddish ? ReddishColor(kind, noise) : Vector3d(grey, grey, grey + blueness);
    AddBox(place_m, stage.foot_m, size_m, yaw_rad, color_rgb, world);
  }
  if (!reddish) return;
  const double side = noise->Chance(0.5) ? 1.0 : -1.0;
  const double size_m = noise->Uniform(0.04, 0.07);
  const Vector2d place_m = stage.At(noise->Uniform(-0.3, 0.1), side * noise->Uniform(0.26, 0.36));
  AddBox(place_m, stage.foot_m, Vector3d::Constant(size_m), noise->Uniform(0.0, 2.0 * kPi),
         kTargetColor_rgb, world);
}

// The sun from the side, far enough from the camera's direction that the target shows it a lit and
// an unlit half, or that what throws a shadow on the target's middle does not hide it.
void AddSun(const Stage& stage, LightCase light, NoiseSource* noise, World* world) {
  const bool shadow = light == LightCase::kShadowEdge;
  const double side = noise->Chance(0.5) ? 1.0 : -1.0;
  const double off_rad =
      RadiansFromDegrees(shadow ? noise->Uniform(50.0, 75.0) : noise->Uniform(60.0, 110.0));
  Lighting::Sun& sun = world->lighting.sun;
  sun.level_1 = kSunLevel_1 * world->lighting.level_1;
  sun.azimuth_rad = stage.camera_rad + side * off_rad;
  sun.elevation_rad = RadiansFromDegrees(noise->Uniform(30.0, 50.0));
  if (!shadow) return;
  constexpr double kAway_m = 1.0, kHalfWidth_m = 0.4, kHeight_m = 1.6;
  const Vector2d to_sun = Direction(sun.azimuth_rad);
  const Vector2d from_camera = side * Vector2d(-to_sun.y(), to_sun.x());
  AddBox(stage.target_m + kAway_m * to_sun + kHalfWidth_m * from_camera, stage.foot_m,
         {0.02, 2.0 * kHalfWidth_m, kHeight_m}, sun.azimuth_rad, {120.0, 120.0, 120.0}, world);
}

// A camera at `eye_m` whose optical axis meets `aim_m`, held upright.
geometry::RigidTransform LookAt(const Vector3d& eye_m, const Vector3d& aim_m) {
  const Vector3d forward = (aim_m - eye_m).normalized();
  const Vector3d right = forward.cross(Vector3d::UnitZ()).normalized();
  Eigen::Matrix3d axes;
  axes << right, forward.cross(right), forward;
  return geometry::MakeTransform(axes, eye_m);
}

}  // namespace

ColorTrial RandomColorTrial(uint64_t seed, int t) {
  NoiseSource noise(HashMix(seed ^ 0x636f6c6fULL, static_cast<uint64_t>(t)));
  constexpr std::array<double, 5> kLamps_K = {2700.0, 3500.0, 5000.0, 7000.0, 10000.0};
  ColorTrial trial;
  // The moduli 7, 25 and 8 have no common factor: every combination comes.
  trial.label = static_cast<GeonLabel>(t % kGeonLabelCount);
  trial.kelvin = kLamps_K[static_cast<size_t>(t % 5)];
  trial.stops = t / 5 % 5 - 2;
  trial.light = static_cast<LightCase>(t % 4);
  trial.distractors = t / 4 % 2 == 1;

  World& world = trial.world;
  world.pen_size_m = {8.0, 8.0};
  world.lighting.kelvin = trial.kelvin;
  world.lighting.level_1 = std::exp2(trial.stops);
  const bool on_desk = noise.Chance(0.5);
  Stage stage;
  stage.target_m = {noise.Uniform(3.8, 4.2), noise.Uniform(3.8, 4.2)};
  stage.foot_m = on_desk ? kDeskHeight_m : 0.0;
  stage.camera_rad = noise.Uniform(0.0, 2.0 * kPi);
  const double distance_m = noise.Uniform(on_desk ? 1.0 : 0.8, 3.0);
  world.lighting.lamp_W_m.head<2>() =
      stage.At(noise.Uniform(0.2, 0.8) * distance_m, noise.Uniform(-0.5, 0.5));
  if (on_desk) {
    AddBox(stage.target_m, 0.0, {1.8, 1.8, kDeskHeight_m}, stage.camera_rad, {110.0, 105.0, 100.0},
           &world);
  }
  AddClutter(stage, trial.distractors, &noise, &world);
  if (trial.light == LightCase::kHalfInSun || trial.light == LightCase::kShadowEdge) {
    AddSun(stage, trial.light, &noise, &world);
  }
  if (trial.light == LightCase::kHighlight) trial.gloss_1 = noise.Uniform(0.3, 0.6);

  WorldObject target;
  target.shape = TargetShape(trial.label, &noise);
  target.x_m = stage.target_m.x();
  target.y_m = stage.target_m.y();
  target.z_m = stage.foot_m;
  target.yaw_rad = noise.Uniform(0.0, 2.0 * kPi);
  target.color_rgb = kTargetColor_rgb;
  trial.target = world.objects.size();
  world.objects.push_back(target);

  const Vector2d eye_m = stage.At(distance_m, 0.0);
  const double eye_height_m = noise.Uniform(1.0, 1.15);
  // The target's middle, up to 3 degrees off the picture's.
  constexpr double kOff_rad = RadiansFromDegrees(3.0);
  const Vector2d aim_m = stage.At(0.0, distance_m * noise.Uniform(-kOff_rad, kOff_rad));
  const double aim_height_m = stage.foot_m + 0.1 + distance_m * noise.Uniform(-kOff_rad, kOff_rad);
  trial.X_WC = LookAt({eye_m.x(), eye_m.y(), eye_height_m}, {aim_m.x(), aim_m.y(), aim_height_m});
  // The robot's floor camera below, 40 degrees down.
  constexpr double kFloorCamera_m = 0.85, kDown_1 = 0.84;
  const Vector2d ahead_m = eye_m - Direction(stage.camera_rad);
  trial.X_WF = LookAt({eye_m.x(), eye_m.y(), kFloorCamera_m},
                      {ahead_m.x(), ahead_m.y(), kFloorCamera_m - kDown_1});
  return trial;
}

ColorPicture RenderColorTrial(const ColorTrial& trial, const geometry::PinholeCamera& camera,
                              const geometry::RigidTransform& X_WCamera,
                              const CameraOptions& options) {
  const Result<std::shared_ptr<const Scene>> built = BuildScene(trial.world);
  Require(built.ok(), "RenderColorTrial: " + built.message());
  // The bodies are the floor and the walls, and then the objects in their order.
  std::vector<Body> bodies = (*built)->bodies();
  const size_t target = bodies.size() - trial.world.objects.size() + trial.target;
  bodies[target].material.gloss_1 = static_cast<float>(trial.gloss_1);
  const Scene scene(std::move(bodies), trial.world.lighting);

  View view;
  LookThrough(scene, camera, X_WCamera, &view);
  ColorPicture picture;
  picture.width_px = camera.width_px;
  picture.height_px = camera.height_px;
  picture.is_target.reserve(view.facet.size());
  for (const int facet : view.facet) {
    const bool on_target =
        facet != View::kNothing &&
        scene.facets().facets()[static_cast<size_t>(facet)].body == static_cast<int>(target);
    picture.is_target.push_back(on_target ? 255 : 0);
  }
  ShadeColor(scene, view, LampShadows::kSoft, &picture.signal);
  for (float& value : picture.signal) value *= static_cast<float>(options.white_1);
  BlurByLens(camera.width_px, camera.height_px, 3, options.blur_1, &picture.signal);
  return picture;
}

std::vector<uint8_t> ExposePicture(const ColorPicture& picture, double exposure_1,
                                   const CameraOptions& options, uint64_t noise_seed) {
  std::vector<float> signal = picture.signal;
  for (float& value : signal) value *= static_cast<float>(exposure_1);
  return ImageSensor(options).Expose(signal, noise_seed);
}

}  // namespace geon::sim
