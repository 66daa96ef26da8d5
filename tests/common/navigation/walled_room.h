#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "base/angles.h"
#include "geometry/rigid_transform.h"
#include "navigation/floor_obstacles.h"

namespace geon::navigation {

// A room with walls along its sides, seen by a camera that looks 2.5 m far, 35 degrees to each
// side.
struct WalledRoom {
  inline static const Eigen::Vector3d kCamera_R_m{0.15, 0.0, 0.85};

  Eigen::Vector2d low_m = {-1.5, -2.0};
  Eigen::Vector2d high_m = {1.5, 2.5};
  double noise_m = 0.01;
  double lean_rad = 0.0;  // of the camera, to the side
  std::mt19937 random{3};

  std::vector<FloorColumn> Look(const geometry::RigidTransform& X_WR) {
    std::normal_distribution<double> noise(0.0, noise_m);
    std::vector<FloorColumn> columns;
    for (int k = -35; k <= 35; ++k) {
      const Eigen::Vector2d along_R(std::cos(RadiansFromDegrees(k)),
                                    std::sin(RadiansFromDegrees(k)));
      const Eigen::Vector2d along_W = X_WR.linear().topLeftCorner<2, 2>() * along_R;
      const Eigen::Vector2d from_W_m = X_WR.translation().head<2>();
      double range_m = 1e9;
      for (int axis = 0; axis < 2; ++axis) {
        const double wall_m = along_W[axis] > 0.0 ? high_m[axis] : low_m[axis];
        range_m = std::min(range_m, (wall_m - from_W_m[axis]) / along_W[axis]);
      }
      FloorColumn column;
      column.begin_R_m = 0.4 * along_R;
      column.obstacle = range_m < 2.5;
      column.end_R_m = (std::min(range_m, 2.5) + noise(random)) * along_R;
      // Leaning to the left by the angle: the ray through a point meets the floor elsewhere.
      const Eigen::Vector3d ray =
          geometry::RotationAboutX(lean_rad) *
          (Eigen::Vector3d(column.end_R_m.x(), column.end_R_m.y(), 0.0) - kCamera_R_m);
      column.end_R_m = (kCamera_R_m - ray * (kCamera_R_m.z() / ray.z())).head<2>();
      columns.push_back(column);
    }
    return columns;
  }
};

}  // namespace geon::navigation
