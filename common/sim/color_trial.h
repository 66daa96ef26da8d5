#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/pinhole_camera.h"
#include "geometry/rigid_transform.h"
#include "sim/camera_options.h"
#include "sim/scene.h"
#include "sim/world.h"

namespace geon::sim {

enum class LightCase { kEven, kHalfInSun, kShadowEdge, kHighlight };

// One picture to find a geon's colour in: a world, and the camera that looks at its geon.
struct ColorTrial {
  World world;
  size_t target = 0;      // its number among world.objects
  double gloss_1 = 0.04;  // of the target's paint
  geometry::RigidTransform X_WC = geometry::RigidTransform::Identity();
  geometry::RigidTransform X_WF = geometry::RigidTransform::Identity();  // of the floor camera
  // What was varied.
  GeonLabel label = GeonLabel::kCuboid;
  double kelvin = 4000.0;  // of the lamp
  int stops = 0;           // light of lamp and sun, in powers of two
  LightCase light = LightCase::kEven;
  bool distractors = false;  // brown, orange, pink and maroon boxes, and a smaller red thing
};

// Trial t of a seed. Any 1,400 trials in a row hold every combination of the seven geons, five
// colours of light (2,700 to 10,000 K), five levels (-2 to +2 stops), four light cases, with and
// without distractors, once; all else is random: pose, size, distance (0.8 to 3 m), the place in
// the picture, on the floor or on a desk.
ColorTrial RandomColorTrial(uint64_t seed, int t);

// What a camera without noise sees of a trial from X_WCamera.
struct ColorPicture {
  int width_px = 0;
  int height_px = 0;
  std::vector<float> signal;       // blue, green, red a pixel, in units of full scale
  std::vector<uint8_t> is_target;  // 255 where the ray through a pixel's middle meets the target
};
ColorPicture RenderColorTrial(const ColorTrial& trial, const geometry::PinholeCamera& camera,
                              const geometry::RigidTransform& X_WCamera,
                              const CameraOptions& options);

// The picture taken with `exposure_1` times the exposure of `options`: blue, green, red a pixel.
std::vector<uint8_t> ExposePicture(const ColorPicture& picture, double exposure_1,
                                   const CameraOptions& options, uint64_t noise_seed);

}  // namespace geon::sim
