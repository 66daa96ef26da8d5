#include "mission/drive.h"

#include <algorithm>
#include <cmath>

#include "navigation/safe_polygon.h"
#include "navigation/waypoint.h"

namespace geon::mission {

namespace {

constexpr double kReached_m = 0.15;  // a wander waypoint

}  // namespace

Drive::Drive(const MissionOptions& options, uint32_t seed)
    : options_(options.driving), random_(seed) {}

navigation::DriveVelocity Drive::Toward(double now_s, const Senses& senses,
                                        const Eigen::Vector2d& p_WTarget_m,
                                        double stop_distance_m) {
  const Eigen::Vector2d target_R_m = geometry::OnGround(senses.X_WR().inverse(), p_WTarget_m);
  const double own_m = stop_distance_m - options_.safe_polygon.clearance_m;
  bending_R_m_.clear();
  std::copy_if(senses.obstacles_R_m().begin(), senses.obstacles_R_m().end(),
               std::back_inserter(bending_R_m_),
               [&](const auto& p_m) { return (p_m - target_R_m).norm() > own_m; });
  polygon_R_ = navigation::SafePolygon(bending_R_m_, options_.safe_polygon);
  return follower_.Go(now_s, navigation::WaypointToTarget(polygon_R_, target_R_m, stop_distance_m),
                      senses.obstacles_R_m(), options_.velocity);
}

navigation::DriveVelocity Drive::Wander(double now_s, const Senses& senses) {
  bending_R_m_ = senses.obstacles_R_m();
  polygon_R_ = navigation::SafePolygon(bending_R_m_, options_.safe_polygon);
  if (wander_W_m_) {
    const Eigen::Vector2d waypoint_R_m = geometry::OnGround(senses.X_WR().inverse(), *wander_W_m_);
    if (waypoint_R_m.norm() < kReached_m || !polygon_R_.Contains(waypoint_R_m, kReached_m) ||
        now_s > wander_until_s_) {
      wander_W_m_.reset();
    }
  }
  if (!wander_W_m_) {
    const auto waypoint_R_m =
        navigation::WanderWaypoint(polygon_R_, options_.wander_min_move_m, random_);
    if (!waypoint_R_m) {
      Rest();
      return {};
    }
    // The default box turns with the robot: a waypoint in its corner would leave it at the first
    // turn.
    const double shorten_1 =
        std::min(1.0, options_.safe_polygon.default_box_m / waypoint_R_m->norm());
    wander_W_m_ = geometry::OnGround(senses.X_WR(), shorten_1 * *waypoint_R_m);
    wander_until_s_ = now_s + options_.wander_s;
  }
  return follower_.Go(now_s, geometry::OnGround(senses.X_WR().inverse(), *wander_W_m_),
                      senses.obstacles_R_m(), options_.velocity);
}

navigation::DriveVelocity Drive::TurnTo(double bearing_rad) const {
  return navigation::TurnTo(bearing_rad, options_.velocity);
}

navigation::DriveVelocity Drive::Creep(double direction, double distance_m,
                                       const Senses& senses) const {
  return navigation::Creep(direction, distance_m, options_.back_off_speed_m_s,
                           senses.obstacles_R_m(), options_.velocity);
}

void Drive::Rest() {
  follower_.Rest();
  wander_W_m_.reset();
}

}  // namespace geon::mission
