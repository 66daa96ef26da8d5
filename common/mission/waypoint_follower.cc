#include "mission/waypoint_follower.h"

#include <algorithm>

namespace geon::mission {

void WaypointFollower::Rest() {
  waypoint_R_m_.setZero();
  speed_m_s_ = 0.0;
  last_s_.reset();
}

navigation::DriveVelocity WaypointFollower::Go(double now_s, const Eigen::Vector2d& waypoint_R_m,
                                               std::span<const Eigen::Vector2d> obstacles_R_m,
                                               const navigation::VelocityLawOptions& options) {
  constexpr double kLongestStep_s = 0.2;  // after a pause the robot starts gently again
  waypoint_R_m_ = waypoint_R_m;
  const double step_s = last_s_ ? std::clamp(now_s - *last_s_, 0.0, kLongestStep_s) : 0.0;
  last_s_ = now_s;
  if (waypoint_R_m.isZero()) {
    speed_m_s_ = 0.0;
    return {};
  }
  const auto velocity =
      navigation::DriveTo(waypoint_R_m, obstacles_R_m, speed_m_s_, step_s, options);
  speed_m_s_ = velocity.speed_m_s;
  return velocity;
}

}  // namespace geon::mission
