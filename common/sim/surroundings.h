#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

namespace geon::sim {

// Where a ray from a sensor meets the world.
struct RayHit {
  double distance_m = 0.0;
  Eigen::Vector3d normal_W = Eigen::Vector3d::UnitZ();  // unit, towards the side the ray comes from
  double reflectance_1 = 0.5;  // share of the light that comes back, 0 to 1
};

// An obstacle near the robot's rim.
struct DiscContact {
  double bearing_rad = 0.0;  // W, from the disc's centre to the obstacle's nearest point
  double clearance_m = 0.0;  // rim to obstacle; negative when they overlap
};

// What the robot's range sensors and its body can feel of the world, asked at one instant. The
// robot itself is no part of it. Frame W is the pen's, metres, z up from the floor.
class Surroundings {
 public:
  static constexpr double kEndless_m = std::numeric_limits<double>::infinity();
  // How far from the rim ContactsOfDisc looks.
  static constexpr double kContactReach_m = 0.05;

  virtual ~Surroundings() = default;

  // The first surface along the ray; `direction_W` is a unit vector. Nothing when the ray escapes;
  // of what is farther than `reach_m` the caller need not be told.
  virtual std::optional<RayHit> CastRay(const Eigen::Vector3d& origin_W_m,
                                        const Eigen::Vector3d& direction_W,
                                        double reach_m = kEndless_m) const = 0;

  // For each obstacle that stands in the way of an upright disc (the body of the robot, from the
  // floor up) and comes within kContactReach_m of its rim: where it is nearest.
  virtual std::vector<DiscContact> ContactsOfDisc(const Eigen::Vector2d& center_W_m,
                                                  double radius_m) const = 0;
};

}  // namespace geon::sim
