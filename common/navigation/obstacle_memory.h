#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "geometry/rigid_transform.h"
#include "navigation/floor_obstacles.h"

namespace geon::navigation {

struct ObstacleMemoryOptions {
  double floor_memory_s = 12.0;  // what the floor camera saw and does not see now
  double sonar_memory_s = 2.5;   // two rounds of the ring, which takes one second
  double cell_m = 0.05;          // one remembered point per cell of this size
  double erase_margin_m = 0.10;  // floor seen this much beyond a point disproves it

  bool IsValid(std::string* error) const;
};

// Source: thesis section 4.3 keeps no memory; this one is ours, for the reason below.
//
// Obstacle points in the odometry frame W, for some seconds: the floor camera cannot see what is
// beside, behind or just below it, and sonar readings are up to a second old.
//
// A point seen by the floor camera lives until it is too old or the camera sees floor where it was;
// sonar, infrared and bumper points only fade, since the camera may not see what echoes.
// Time is the caller's, in seconds; it must not run backwards.
class ObstacleMemory {
 public:
  explicit ObstacleMemory(const ObstacleMemoryOptions& options);

  // One floor image: forgets the points it disproves, then adds its obstacles. Columns run from
  // left to right as FloorObstacles gives them.
  void SeeFloor(double now_s, const geometry::RigidTransform& X_WR,
                std::span<const FloorColumn> columns);
  // Points of R that a sonar, infrared or bumper ring reported.
  void Feel(double now_s, const geometry::RigidTransform& X_WR,
            std::span<const Eigen::Vector2d> points_R_m);
  void Forget(double now_s);
  void Clear() { points_.clear(); }

  // All remembered points, in the robot's frame (X_RW), into `points_R_m`.
  void In(const geometry::RigidTransform& X_RW, std::vector<Eigen::Vector2d>* points_R_m) const;

 private:
  struct Remembered {
    Eigen::Vector2d p_W_m;
    double until_s;
    bool from_floor;
  };
  void Add(const Eigen::Vector2d& p_W_m, double until_s, bool from_floor);

  ObstacleMemoryOptions options_;
  std::vector<Remembered> points_;
};

}  // namespace geon::navigation
