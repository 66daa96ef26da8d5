#pragma once

#include <Eigen/Core>
#include <cmath>

#include "geometry/pinhole_camera.h"
#include "geometry/rigid_transform.h"

namespace geon::sim {

// A real lens before an ideal camera: what belongs at one pixel is seen at another.
//
// Source: Fitzgibbon, "Simultaneous linear estimation of multiple view geometry and lens
// distortion", 2001 (the division model): about the lens's own middle, which is not the camera's
// principal point, ideal = seen / (1 + bend * seen^2). Another model than any that a calibration
// fits, so that a calibration meets what it did not expect.
struct Lens {
  double bend_1_px2 = 0.0;  // below 0: barrel; 0: no distortion
  Eigen::Vector2d middle_px = Eigen::Vector2d::Zero();

  Eigen::Vector2d Ideal(const Eigen::Vector2d& seen_px) const {
    const Eigen::Vector2d out_px = seen_px - middle_px;
    return middle_px + out_px / (1.0 + bend_1_px2 * out_px.squaredNorm());
  }
  Eigen::Vector2d Seen(const Eigen::Vector2d& ideal_px) const {
    const Eigen::Vector2d out_px = ideal_px - middle_px;
    return middle_px +
           out_px * (2.0 / (1.0 + std::sqrt(1.0 - 4.0 * bend_1_px2 * out_px.squaredNorm())));
  }
};

// A camera as it was built: x right, y down, z forward, pixel (0, 0) is the centre of the top left
// pixel.
struct BuiltCamera {
  geometry::PinholeCamera ideal;  // without distortion
  Lens lens;

  // Direction (z = 1) of the light that comes to a pixel.
  Eigen::Vector3d Ray(const Eigen::Vector2d& seen_px) const {
    const Eigen::Vector2d ideal_px = lens.Ideal(seen_px);
    return ideal.Ray(ideal_px.x(), ideal_px.y());
  }
  // Where a point with z > 0 is seen.
  Eigen::Vector2d Project(const Eigen::Vector3d& p_C_m) const {
    return lens.Seen(ideal.Project(p_C_m));
  }
};

}  // namespace geon::sim
