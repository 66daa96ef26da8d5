#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

namespace geon::sim {

// How far a camera's sight moves on a surface from a pixel to the next along u and v: the sides of
// what a pixel sees, on the plane that touches the surface there. `from_eye_m` leads from the
// camera to the surface, `ray_steps` from a ray of depth 1 to the next, all in one frame.
inline std::array<Eigen::Vector3f, 2> PixelFootprint(
    const Eigen::Vector3f& from_eye_m, const Eigen::Vector3f& normal, const Eigen::Vector3f& ahead,
    const std::array<Eigen::Vector3f, 2>& ray_steps) {
  const float depth_m = from_eye_m.dot(ahead);
  const Eigen::Vector3f ray = from_eye_m / depth_m;
  // A surface seen edge-on would spread without bounds.
  const float facing = std::min(-0.05F, normal.dot(ray));
  const auto on_surface = [&](const Eigen::Vector3f& step) -> Eigen::Vector3f {
    return depth_m * (step - ray * (normal.dot(step) / facing));
  };
  return {on_surface(ray_steps[0]), on_surface(ray_steps[1])};
}

}  // namespace geon::sim
