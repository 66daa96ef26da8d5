#pragma once

#include <Eigen/Core>

namespace geon::geometry {

// A pinhole camera behind a lens with radial distortion: x right, y down, z forward, pixel (0, 0)
// is the centre of the top left pixel.
//
// Source: Brown, "Close-range camera calibration", 1971 (the even polynomial that OpenCV calls k1,
// k2): a ray (x, y, 1) with r^2 = x^2 + y^2 is seen where an ideal camera would see (x, y) (1 + k1
// r^2 + k2 r^4). Both 0 is an ideal camera, as the thesis takes its 16 mm lenses to be (section
// 3.2).
struct PinholeCamera {
  int width_px = 640;
  int height_px = 480;
  double fx_px = 1600.0;
  double fy_px = 1600.0;
  double cx_px = 319.5;
  double cy_px = 239.5;
  double k1_1 = 0.0;
  double k2_1 = 0.0;

  // Direction (not normalised, z = 1) of the ray through a pixel, camera frame.
  Eigen::Vector3d Ray(double u_px, double v_px) const {
    const Eigen::Vector3d seen((u_px - cx_px) / fx_px, (v_px - cy_px) / fy_px, 1.0);
    if (k1_1 == 0.0 && k2_1 == 0.0) return seen;
    // Each round leaves about k1 r^2 of the error: a lens of 1 % is exact to 1e-12 after six.
    constexpr int kRounds = 8;
    Eigen::Vector3d ray = seen;
    for (int round = 0; round < kRounds; ++round) {
      ray.head<2>() = seen.head<2>() / Stretch(ray.head<2>().squaredNorm());
    }
    return ray;
  }
  // Pixel of a point in the camera frame; the point must lie in front (z > 0).
  Eigen::Vector2d Project(const Eigen::Vector3d& p_C) const {
    const double x = p_C.x() / p_C.z();
    const double y = p_C.y() / p_C.z();
    const double stretch = Stretch(x * x + y * y);
    return {cx_px + fx_px * (x * stretch), cy_px + fy_px * (y * stretch)};
  }
  bool Contains(const Eigen::Vector2d& pixel_px) const {
    return pixel_px.x() >= -0.5 && pixel_px.x() < width_px - 0.5 && pixel_px.y() >= -0.5 &&
           pixel_px.y() < height_px - 0.5;
  }

 private:
  double Stretch(double r2) const { return 1.0 + r2 * (k1_1 + r2 * k2_1); }
};

}  // namespace geon::geometry
