#include "mission/drive.h"

#include <algorithm>
#include <cmath>

#include "navigation/safe_polygon.h"
#include "navigation/waypoint.h"

namespace geon::mission {

namespace {

constexpr double kReached_m = 0.15;     // a wander waypoint
constexpr double kLongestStep_s = 0.2;  // after a pause the robot starts gently again

Eigen::Vector2d Apply(const geometry::RigidTransform& X_AB, const Eigen::Vector2d& p_B_m) {
  return (X_AB * Eigen::Vector3d(p_B_m.x(), p_B_m.y(), 0.0)).head<2>();
}

}  // namespace

Drive::Drive(const MissionOptions& options, uint32_t seed)
    : options_(options.driving), random_(seed) {}

navigation::DriveVelocity Drive::Toward(double now_s, const Senses& senses,
                                        const Eigen::Vector2d& p_WTarget_m,
                                        double stop_distance_m) {
  const Eigen::Vector2d target_R_m = Apply(senses.X_WR().inverse(), p_WTarget_m);
  const double own_m = stop_distance_m - options_.safe_polygon.clearance_m;
  bending_R_m_.clear();
  std::copy_if(senses.obstacles_R_m().begin(), senses.obstacles_R_m().end(),
               std::back_inserter(bending_R_m_),
               [&](const auto& p_m) { return (p_m - target_R_m).norm() > own_m; });
  polygon_R_ = navigation::SafePolygon(bending_R_m_, options_.safe_polygon);
  return Go(now_s, navigation::WaypointToTarget(polygon_R_, target_R_m, stop_distance_m), senses);
}

navigation::DriveVelocity Drive::Wander(double now_s, const Senses& senses) {
  bending_R_m_ = senses.obstacles_R_m();
  polygon_R_ = navigation::SafePolygon(bending_R_m_, options_.safe_polygon);
  if (wander_W_m_) {
    const Eigen::Vector2d waypoint_R_m = Apply(senses.X_WR().inverse(), *wander_W_m_);
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
    wander_W_m_ = Apply(senses.X_WR(), shorten_1 * *waypoint_R_m);
    wander_until_s_ = now_s + options_.wander_s;
  }
  return Go(now_s, Apply(senses.X_WR().inverse(), *wander_W_m_), senses);
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
  speed_m_s_ = 0.0;
  last_s_.reset();
  wander_W_m_.reset();
}

navigation::DriveVelocity Drive::Go(double now_s, const Eigen::Vector2d& waypoint_R_m,
                                    const Senses& senses) {
  waypoint_R_m_ = waypoint_R_m;
  const double step_s = last_s_ ? std::clamp(now_s - *last_s_, 0.0, kLongestStep_s) : 0.0;
  last_s_ = now_s;
  if (waypoint_R_m.isZero()) {
    speed_m_s_ = 0.0;
    return {};
  }
  const auto velocity = navigation::DriveTo(waypoint_R_m, senses.obstacles_R_m(), speed_m_s_,
                                            step_s, options_.velocity);
  speed_m_s_ = velocity.speed_m_s;
  return velocity;
}

}  // namespace geon::mission
