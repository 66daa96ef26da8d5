#pragma once

#include <Eigen/Core>

namespace geon::geometry {

// An ideal pinhole camera: x right, y down, z forward, pixel (0, 0) is the centre of the top left
// pixel. The 16 mm lenses of the rig have negligible distortion (thesis section 3.2).
struct PinholeCamera {
  int width_px = 640;
  int height_px = 480;
  double fx_px = 1600.0;
  double fy_px = 1600.0;
  double cx_px = 319.5;
  double cy_px = 239.5;

  // Direction (not normalised, z = 1) of the ray through a pixel, camera frame.
  Eigen::Vector3d Ray(double u_px, double v_px) const {
    return {(u_px - cx_px) / fx_px, (v_px - cy_px) / fy_px, 1.0};
  }
  // Pixel of a point in the camera frame; the point must lie in front (z > 0).
  Eigen::Vector2d Project(const Eigen::Vector3d& p_C) const {
    return {cx_px + fx_px * p_C.x() / p_C.z(), cy_px + fy_px * p_C.y() / p_C.z()};
  }
  bool Contains(const Eigen::Vector2d& pixel_px) const {
    return pixel_px.x() >= -0.5 && pixel_px.x() < width_px - 0.5 && pixel_px.y() >= -0.5 &&
           pixel_px.y() < height_px - 0.5;
  }
};

}  // namespace geon::geometry
