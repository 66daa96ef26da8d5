#pragma once

#include <cstdint>
#include <vector>

#include "sim/camera_options.h"
#include "sim/lens.h"
#include "sim/scene.h"

namespace geon::sim {

// A line laser in place: a fan of light in a plane, but for its bow (see BuiltLaser).
struct LaserFan {
  Eigen::Vector3d origin_W_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_W = Eigen::Vector3d::UnitZ();   // unit, of the fan's plane
  Eigen::Vector3d forward_W = Eigen::Vector3d::UnitX();  // unit, middle of the fan, in its plane
  double bow_1 = 0.0;
  bool stripe_runs_along_u = true;  // in the image: a horizontal stripe
};

// The laser's light that comes to a pixel, in units of the camera's full scale.
struct LitPixel {
  int u_px, v_px;
  float level_1;
};

// All pixels of the camera in the laser's light, row by row.
//
// The fan has a Gaussian cross-section, integrated over each pixel's footprint on the surface; the
// surface answers by its reflectance at 670 nm and the cosine of the incidence; what stands in the
// laser's way shadows it. Speckle belongs to `speckle_seed`: it stands still as long as the scene
// and the rig do.
//
// Rays in the fan tell where in the picture to look; each pixel there is then asked by rays of its
// own, to the surface and on to the laser.
std::vector<LitPixel> LaserLight(const Scene& scene, const BuiltCamera& camera,
                                 const geometry::RigidTransform& X_WC, const LaserFan& fan,
                                 const LaserOptions& options, uint64_t speckle_seed);

}  // namespace geon::sim
