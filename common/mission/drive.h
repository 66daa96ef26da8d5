#pragma once

#include <Eigen/Core>
#include <optional>
#include <random>
#include <vector>

#include "geometry/convex_polygon.h"
#include "mission/mission_options.h"
#include "mission/senses.h"
#include "mission/waypoint_follower.h"
#include "navigation/velocity_law.h"

namespace geon::mission {

// The planner `thesis`: from what stands around the robot to its next velocities (thesis 4.3).
class Drive {
 public:
  Drive(const MissionOptions& options, uint32_t seed);

  // Toward a place in W, to stop `stop_distance_m` before it. What stands so near to the target
  // that a robot which stops there cannot touch it does not bend the way (the target itself, its
  // desk); it still limits the speed.
  navigation::DriveVelocity Toward(double now_s, const Senses& senses,
                                   const Eigen::Vector2d& p_WTarget_m, double stop_distance_m);
  // Somewhere, until told otherwise; a new waypoint when the old one is reached, cut off or old.
  navigation::DriveVelocity Wander(double now_s, const Senses& senses);
  navigation::DriveVelocity TurnTo(double bearing_rad) const;
  // Away from whatever is ahead (or behind, `direction` +1), slowly, along the heading.
  navigation::DriveVelocity Creep(double direction, double distance_m, const Senses& senses) const;

  // Forgets the speed and the wandering; call when something else took over meanwhile.
  void Rest();

  // What the last answer was made of, frame R, for people.
  const geometry::ConvexPolygon& polygon_R() const { return polygon_R_; }
  const Eigen::Vector2d& waypoint_R_m() const { return follower_.waypoint_R_m(); }

 private:
  DrivingOptions options_;
  std::mt19937 random_;
  std::vector<Eigen::Vector2d> bending_R_m_;
  geometry::ConvexPolygon polygon_R_;
  WaypointFollower follower_;
  std::optional<Eigen::Vector2d> wander_W_m_;
  double wander_until_s_ = 0.0;
};

}  // namespace geon::mission
