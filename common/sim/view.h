#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "geometry/pinhole_camera.h"
#include "geometry/rigid_transform.h"
#include "sim/scene.h"

namespace geon::sim {

// What each pixel of a camera looks at: the facet (Facets) that the ray through the pixel's middle
// meets first, row by row. sim/surface_row.h tells where.
//
// Not the pixels ask the world, but each facet in turn claims the pixels whose rays cross it: a ray
// (u, v, 1) crosses a triangle of corners a, b, c (in the same coordinates, times their depths) if
// it lies on one side of the three planes through the eye and an edge. That is exact, however thin
// a thing may be, needs no clipping at the camera's plane, and both neighbours of an edge find the
// same bits for it, so that no ray slips through. The inverse of the depth is linear in u and v.
struct View {
  static constexpr int kNothing = -1;  // the ray leaves the world

  geometry::PinholeCamera camera;
  geometry::RigidTransform X_WC = geometry::RigidTransform::Identity();
  std::vector<int> facet;
  std::vector<float> nearness_1_m;  // inverse of the depth along the optical axis; 0: nothing
  // Corners of the facets: (u, v, 1) times the depth. Only of bodies that may be in the picture.
  std::vector<Eigen::Vector3d> corners_px_m;
  std::vector<Eigen::Vector3f> corners_px;  // (u, v, depth), rounded: enough to look near them
};

// Fills `view`, whose memory is used again.
void LookThrough(const Scene& scene, const geometry::PinholeCamera& camera,
                 const geometry::RigidTransform& X_WC, View* view);

}  // namespace geon::sim
