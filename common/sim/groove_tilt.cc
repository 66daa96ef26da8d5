#include "sim/groove_tilt.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/angles.h"

namespace geon::sim {
namespace {

constexpr double kWheelCircle_m = 0.19;  // radius of the circle on which the wheels stand
constexpr double kGrooveBottom_m =
    0.010;  // the wheel is all the way down so near to the groove's middle
constexpr double kGrooveEdge_m = 0.030;  // and not at all beyond this

// 0 on the tile, 1 at the bottom of the nearest groove.
double Depth(double x_m, double tile_m) {
  const double distance_m = std::abs(x_m - tile_m * std::round(x_m / tile_m));
  const double out_1 = (distance_m - kGrooveBottom_m) / (kGrooveEdge_m - kGrooveBottom_m);
  return 0.5 * (1.0 + std::cos(kPi * std::clamp(out_1, 0.0, 1.0)));
}

}  // namespace

Eigen::Matrix3d GrooveTilt(const FloorGrooves& grooves, const Eigen::Vector2d& center_W_m,
                           double base_rad) {
  if (grooves.tilt_rad <= 0.0) return Eigen::Matrix3d::Identity();
  // One wheel all the way down tilts the plane of three by drop / (1.5 radius).
  const double drop_m = 1.5 * kWheelCircle_m * std::tan(grooves.tilt_rad);
  Eigen::Vector2d slope_1 = Eigen::Vector2d::Zero();
  for (int wheel = 0; wheel < 3; ++wheel) {
    const double leg_rad = base_rad + 2.0 * kPi * wheel / 3.0;
    const Eigen::Vector2d leg(std::cos(leg_rad), std::sin(leg_rad));
    const Eigen::Vector2d foot_m = center_W_m + kWheelCircle_m * leg;
    const double depth_1 =
        std::max(Depth(foot_m.x(), grooves.tile_m), Depth(foot_m.y(), grooves.tile_m));
    slope_1 -= 2.0 / (3.0 * kWheelCircle_m) * drop_m * depth_1 * leg;
  }
  const Eigen::Vector3d up(-slope_1.x(), -slope_1.y(), 1.0);
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), up).toRotationMatrix();
}

}  // namespace geon::sim
