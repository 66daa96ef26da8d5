#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <vector>

#include "base/angles.h"
#include "geometry/rigid_transform.h"
#include "sensor/scan_set.h"

namespace geon::recognition {

// How a synthetic scan looks at an object that stands on z = 0 above the origin.
struct SyntheticView {
  double range_m = 1.05;                            // camera to the object's middle
  double elevation_rad = RadiansFromDegrees(25.0);  // of the camera above the object
  double noise_px = 0.1;                            // on the stripe, standard deviation
  double focal_px = 1600.0;
  double baseline_m = 0.125;
  double placement_error_1 = 0.02;  // of the stripes, in fractions of the target box
};

// Distance along a ray (origin, unit direction) to the object, if it hits.
using CastRay =
    std::function<std::optional<double>(const Eigen::Vector3d&, const Eigen::Vector3d&)>;

// What six stripes see of an object on a floor: triangulation in perspective, with occlusion of
// either ray, pixel columns and noise across the stripe. `bounds` hold the object. Nothing if it
// does not fit the image. Made for testing recognition: shares nothing with the simulator.
inline std::optional<sensor::ScanSet> MakeSyntheticScan(const CastRay& cast,
                                                        const std::vector<Eigen::Vector3d>& outline,
                                                        const SyntheticView& view,
                                                        std::mt19937_64& random) {
  constexpr int kWidth_px = 640;
  constexpr int kHeight_px = 480;
  constexpr double kColorAbove_m = 0.065;  // the colour camera above the B/W camera
  std::normal_distribution<double> gauss;

  double top_m = 0.0;
  for (const Eigen::Vector3d& p : outline) top_m = std::max(top_m, p.z());
  const double c = std::cos(view.elevation_rad);
  const double s = std::sin(view.elevation_rad);
  // Frame L: camera above its origin, object straight ahead.
  const Eigen::Vector3d p_LB(0, 0, 0.5 * top_m + view.range_m * s);
  const Eigen::Vector3d object_L(view.range_m * c, 0, 0);
  const Eigen::Matrix3d R_LB =
      geometry::RotationAboutY(view.elevation_rad) * geometry::CameraAxesInBody();

  const auto color_pixel = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d p_C =
        R_LB.transpose() * (object_L + p - p_LB) + Eigen::Vector3d(0, kColorAbove_m, 0);
    return Eigen::Vector2d(319.5 + view.focal_px * p_C.x() / p_C.z(),
                           239.5 + view.focal_px * p_C.y() / p_C.z());
  };
  // The head has centred the target: the box is what counts, not its absolute place in height.
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& p : outline) box.extend(color_pixel(p));
  if (box.min().x() < 5 || box.max().x() > kWidth_px - 6 || box.sizes().y() > kHeight_px - 12) {
    return std::nullopt;
  }

  const auto cast_scene = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
    std::optional<double> hit = cast(from - object_L, direction);
    if (direction.z() < 0.0) {
      const double floor_m = -from.z() / direction.z();
      if (!hit || floor_m < *hit) hit = floor_m;
    }
    return hit;
  };

  sensor::ScanSet scan;
  scan.camera_position_L_m = p_LB;
  scan.rotation_LB = R_LB;
  const int box_top_px = static_cast<int>(std::lround(box.min().y()));
  scan.target_box = sensor::PixelBox{static_cast<int>(std::lround(box.min().x())), box_top_px,
                                     static_cast<int>(std::lround(box.sizes().x())),
                                     static_cast<int>(std::lround(box.sizes().y()))};
  for (int k = 0; k < 6; ++k) {
    const bool vertical = k >= 3;
    const double fraction = 0.25 * (k % 3 + 1);
    const double at = fraction + view.placement_error_1 * gauss(random);
    const Eigen::Vector2d wanted_px =
        vertical ? Eigen::Vector2d(box.min().x() + at * box.sizes().x(), box.center().y())
                 : Eigen::Vector2d(box.center().x(), box.min().y() + at * box.sizes().y());
    const Eigen::Vector3d ray((wanted_px.x() - 319.5) / view.focal_px,
                              (wanted_px.y() - 239.5) / view.focal_px, 1.0);
    const Eigen::Vector3d wanted_B = view.range_m * ray - Eigen::Vector3d(0, kColorAbove_m, 0);
    const Eigen::Vector3d laser_B = vertical ? Eigen::Vector3d(-view.baseline_m, 0, 0)
                                             : Eigen::Vector3d(0, -view.baseline_m, 0);
    const Eigen::Vector3d forward_B = (wanted_B - laser_B).normalized();
    const Eigen::Vector3d along_B = vertical ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
    const Eigen::Vector3d side_B = (along_B - forward_B * forward_B.dot(along_B)).normalized();
    const Eigen::Vector3d normal_B = side_B.cross(forward_B);

    sensor::RangeProfile profile;
    profile.stripe_index = k;
    profile.laser = vertical ? sensor::Laser::kVertical : sensor::Laser::kHorizontal;
    profile.fraction = fraction;
    const Eigen::Vector3d laser_L = p_LB + R_LB * laser_B;
    profile.laser_origin_L_m = laser_L;
    profile.rotation_LB = R_LB;
    // Across the stripe's pixel: the mean of all light that falls into it.
    std::map<int, std::pair<double, int>> light;
    constexpr int kRays = 900;
    for (int j = 0; j < kRays; ++j) {
      const double tangent = 0.22 * (2.0 * j / (kRays - 1) - 1.0);
      const Eigen::Vector3d beam_L = R_LB * (forward_B + tangent * side_B).normalized();
      const std::optional<double> lit_m = cast_scene(laser_L, beam_L);
      if (!lit_m) continue;
      const Eigen::Vector3d p_L = laser_L + *lit_m * beam_L;
      const Eigen::Vector3d to_point = p_L - p_LB;
      const double distance_m = to_point.norm();
      const std::optional<double> seen_m = cast_scene(p_LB, to_point / distance_m);
      if (!seen_m || *seen_m < distance_m - 1e-3) continue;
      const Eigen::Vector3d p_B = R_LB.transpose() * to_point;
      const double u_px = 319.5 + view.focal_px * p_B.x() / p_B.z();
      const double v_px = 239.5 + view.focal_px * p_B.y() / p_B.z();
      const int line = static_cast<int>(std::lround(vertical ? v_px : u_px));
      // The head tilts for horizontal stripes: only the width of the image limits them.
      if (!vertical && (line < 0 || line >= kWidth_px)) continue;
      if (vertical && std::abs(v_px - (box.center().y() + 40.0)) > 0.5 * kHeight_px) continue;
      std::pair<double, int>& sum = light[line];
      sum.first += vertical ? u_px : v_px;
      ++sum.second;
    }
    for (const auto& [line, sum] : light) {
      const double across_px = sum.first / sum.second + view.noise_px * gauss(random);
      const double u = ((vertical ? across_px : line) - 319.5) / view.focal_px;
      const double v = ((vertical ? line : across_px) - 239.5) / view.focal_px;
      const Eigen::Vector3d direction_B(u, v, 1.0);
      const double z_m = normal_B.dot(laser_B) / normal_B.dot(direction_B);
      if (z_m < 0.3 || z_m > 4.0) continue;
      profile.pixel.push_back(line);
      profile.p_L_m.push_back(p_LB + R_LB * (z_m * direction_B));
    }
    scan.profiles.push_back(profile);
  }
  return scan;
}

}  // namespace geon::recognition
