#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

namespace geon::navigation {

struct VelocityLawOptions {
  double max_speed_m_s = 0.5;          // thesis section 3.4: 50 cm/s
  double max_turn_rate_rad_s = 1.047;  // 60 degrees/s
  double acceleration_m_s2 = 0.6;      // speeding up
  double deceleration_m_s2 = 0.4;      // counted on for stopping; the base brakes harder
  double reaction_s = 0.35;            // from a sensor's reading to the base's answer
  double turn_gain_1_s = 2.0;          // turn rate per radian off course
  double drive_cone_rad = 0.60;        // farther off course than this: turn on the spot first
  double body_radius_m = 0.267;
  double side_margin_m = 0.02;   // added to the body when looking for obstacles ahead
  double front_margin_m = 0.06;  // left between body and obstacle when stopped

  bool IsValid(std::string* error) const;
};

struct DriveVelocity {
  double speed_m_s = 0.0;
  double turn_rate_rad_s = 0.0;
};

// How far the body can move straight ahead (`direction` +1) or back (-1) before it comes within the
// margins of a point. Infinite when nothing is in the way. Frame R.
double FreeTravel(std::span<const Eigen::Vector2d> obstacles_R_m, double direction,
                  const VelocityLawOptions& options);

// The fastest speed from which the robot comes to rest within `distance_m`, reaction time included.
double StoppingSpeed(double distance_m, const VelocityLawOptions& options);

// The speed from which the robot comes to rest at a place `distance_m` away as gently as it
// started. Nothing stands there, so that rolling on for the reaction time does no harm.
double ArrivingSpeed(double distance_m, const VelocityLawOptions& options);

// Turns toward the waypoint, then drives, never faster than allows to stop before the nearest
// obstacle ahead and at the waypoint, and gently up from `previous_speed_m_s`, `step_s` ago. A
// synchro-drive robot is a disc that turns in its own place, so turning is always safe. Frame R.
//
// Source: thesis section 4.3 leaves the motion open; limits are section 3.4's.
DriveVelocity DriveTo(const Eigen::Vector2d& waypoint_R_m,
                      std::span<const Eigen::Vector2d> obstacles_R_m, double previous_speed_m_s,
                      double step_s, const VelocityLawOptions& options);

// Straight ahead (`direction` +1) or back (-1) by `distance_m` at no more than `max_speed_m_s`,
// with the same care for what is there.
DriveVelocity Creep(double direction, double distance_m, double max_speed_m_s,
                    std::span<const Eigen::Vector2d> obstacles_R_m,
                    const VelocityLawOptions& options);

// Turns on the spot toward a bearing (frame R).
DriveVelocity TurnTo(double bearing_rad, const VelocityLawOptions& options);

}  // namespace geon::navigation
