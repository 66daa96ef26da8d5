#include "navigation/velocity_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/contracts.h"

namespace geon::navigation {

bool VelocityLawOptions::IsValid(std::string* error) const {
  const auto fail = [&](const std::string& rule) {
    if (error != nullptr) *error = rule;
    return false;
  };
  for (const double value : {max_speed_m_s, max_turn_rate_rad_s, acceleration_m_s2,
                             deceleration_m_s2, turn_gain_1_s, drive_cone_rad, body_radius_m}) {
    if (!(value > 0.0))
      return fail("speeds, accelerations, gain, cone and radius must be positive");
  }
  if (!(reaction_s >= 0.0)) return fail("reaction_s must not be negative");
  if (!(side_margin_m >= 0.0 && front_margin_m >= 0.0)) {
    return fail("margins must not be negative");
  }
  return true;
}

double FreeTravel(std::span<const Eigen::Vector2d> obstacles_R_m, double direction,
                  const VelocityLawOptions& options) {
  const double reach_m = options.body_radius_m + options.side_margin_m;
  double free_m = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& p_m : obstacles_R_m) {
    const double ahead_m = direction * p_m.x();
    if (ahead_m <= 0.0 || std::abs(p_m.y()) >= reach_m) continue;
    const double body_m = std::sqrt(reach_m * reach_m - p_m.y() * p_m.y());
    free_m = std::min(free_m, ahead_m - body_m);
  }
  return std::max(0.0, free_m - (options.front_margin_m - options.side_margin_m));
}

double StoppingSpeed(double distance_m, const VelocityLawOptions& options) {
  if (distance_m <= 0.0) return 0.0;
  const double a_m_s2 = options.deceleration_m_s2;
  const double t_s = options.reaction_s;
  // v t + v^2 / (2 a) = d
  const double v_m_s = a_m_s2 * (std::sqrt(t_s * t_s + 2.0 * distance_m / a_m_s2) - t_s);
  return std::min(v_m_s, options.max_speed_m_s);
}

double ArrivingSpeed(double distance_m, const VelocityLawOptions& options) {
  return std::sqrt(2.0 * options.acceleration_m_s2 * std::max(0.0, distance_m));
}

DriveVelocity TurnTo(double bearing_rad, const VelocityLawOptions& options) {
  const double limit_rad_s = options.max_turn_rate_rad_s;
  return {0.0, std::clamp(options.turn_gain_1_s * bearing_rad, -limit_rad_s, limit_rad_s)};
}

DriveVelocity DriveTo(const Eigen::Vector2d& waypoint_R_m,
                      std::span<const Eigen::Vector2d> obstacles_R_m, double previous_speed_m_s,
                      double step_s, const VelocityLawOptions& options) {
  std::string error;
  Require(options.IsValid(&error), error);
  const double bearing_rad = std::atan2(waypoint_R_m.y(), waypoint_R_m.x());
  DriveVelocity velocity = TurnTo(bearing_rad, options);
  const double off_course_rad = std::abs(bearing_rad);
  if (off_course_rad >= options.drive_cone_rad) return velocity;

  // Straight on at the cone's centre, nothing at its edge: the path stays near the straight
  // segment.
  const double alignment = 1.0 - off_course_rad / options.drive_cone_rad;
  const double ahead_m = FreeTravel(obstacles_R_m, 1.0, options);
  const double gentle_m_s = std::max(0.0, previous_speed_m_s) + options.acceleration_m_s2 * step_s;
  velocity.speed_m_s = std::min({alignment * options.max_speed_m_s, StoppingSpeed(ahead_m, options),
                                 ArrivingSpeed(waypoint_R_m.norm(), options), gentle_m_s});
  return velocity;
}

DriveVelocity Creep(double direction, double distance_m, double max_speed_m_s,
                    std::span<const Eigen::Vector2d> obstacles_R_m,
                    const VelocityLawOptions& options) {
  const double free_m = FreeTravel(obstacles_R_m, direction, options);
  return {direction * std::min({max_speed_m_s, StoppingSpeed(distance_m, options),
                                StoppingSpeed(free_m, options)}),
          0.0};
}

}  // namespace geon::navigation
