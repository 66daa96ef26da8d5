#pragma once

#include <cstdint>
#include <vector>

#include "geometry/pinhole_camera.h"
#include "geometry/rigid_transform.h"
#include "sim/scene.h"

namespace geon::sim {

// What each pixel of a camera looks at: one ray through the middle of each pixel, row by row.
struct View {
  geometry::PinholeCamera camera;
  geometry::RigidTransform X_WC = geometry::RigidTransform::Identity();
  std::vector<Sighting> sightings;
};

// Fills `view`, whose memory is used again.
void LookThrough(const Scene& scene, const geometry::PinholeCamera& camera,
                 const geometry::RigidTransform& X_WC, View* view);

enum class LampShadows { kSoft, kNone };

// Light that comes to each pixel, linear, 3 values (red, green, blue) a pixel, without noise:
// diffuse and mirrored light of the lamp and the sun (hard shadows), and what the room reflects.
std::vector<float> ShadeColor(const Scene& scene, const View& view, LampShadows shadows);

}  // namespace geon::sim
