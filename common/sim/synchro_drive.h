#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "base/angles.h"
#include "sim/groove_tilt.h"
#include "sim/surroundings.h"
#include "sim/trapezoid_axis.h"

namespace geon::sim {

struct SynchroDriveOptions {
  double x_m = 0.0;  // where it is switched on, frame W
  double y_m = 0.0;
  double heading_rad = 0.0;
  double radius_m = 0.267;
  double max_speed_m_s = 0.508;  // 20 in/s
  double max_turn_rate_rad_s = RadiansFromDegrees(60.0);
  double max_acceleration_m_s2 = 0.762;  // 30 in/s^2
  double max_turn_acceleration_rad_s2 = RadiansFromDegrees(60.0);
  // Deceleration when told to hold: the motors brake harder than they are asked to accelerate.
  double hold_deceleration_m_s2 = 1.5;
  double hold_turn_deceleration_rad_s2 = RadiansFromDegrees(180.0);
  // What the encoders count for one unit really travelled: worn tyres, a tilted floor.
  double odometry_distance_scale_1 = 1.0;
  double odometry_turn_scale_1 = 1.0;
  FloorGrooves grooves;
};

enum class Servo { kTranslation = 0, kSteering = 1, kTurret = 2 };
inline constexpr std::array<Servo, 3> kServos = {Servo::kTranslation, Servo::kSteering,
                                                 Servo::kTurret};

// The Nomad 200's body: an upright disc on three wheels that steer together, and a turret above
// them. The base itself does not turn. Each servo is driven by velocity or by position within its
// limits; units are metres and radians of its encoder.
//
// A wall met squarely stops the disc and its wheels stall. Met at a slant it turns the disc aside:
// the disc slides along it while the wheels slip, and the odometry does not know.
class SynchroDrive {
 public:
  // `surroundings` outlives the drive.
  SynchroDrive(const SynchroDriveOptions& options, const Surroundings* surroundings);

  // Commands are clamped to the robot's own limits.
  void SetAcceleration(Servo servo, double acceleration);
  void SetSpeed(Servo servo, double speed);  // of moves to a position
  void RunAt(Servo servo, double velocity);
  void MoveBy(Servo servo, double distance);
  void MoveTo(Servo servo, double position);
  void Hold(Servo servo);  // brake and stand
  void Limp(Servo servo);  // motor off: rolls out at half the hold deceleration
  // Ties the turret to the steering (it ends its own motion at once), or lets it go.
  void TieTurret(bool tied);
  bool turret_tied() const { return turret_tied_; }
  void Step(double dt_s);

  // Encoders and odometry: what the robot knows of itself, zero when switched on.
  double position(Servo servo) const { return axis(servo).position(); }
  double velocity(Servo servo) const { return axis(servo).velocity(); }
  bool moving(Servo servo) const { return axis(servo).moving(); }
  double acceleration(Servo servo) const { return accelerations_[Index(servo)]; }
  const Eigen::Vector2d& odometry_m() const { return odometry_m_; }
  void DefinePosition(const Eigen::Vector2d& position_m) { odometry_m_ = position_m; }
  void DefineAngle(Servo servo, double angle_rad);
  // Forgets every setting, target and reading; stays where it is, its base frame as it is.
  void PowerCycle();

  // The truth.
  const Eigen::Vector2d& center_W_m() const { return center_W_m_; }
  double heading_W_rad() const { return heading_W_rad_; }  // where the wheels point
  double turret_W_rad() const { return turret_W_rad_; }
  double base_W_rad() const { return options_.heading_rad; }  // never turns
  // How the floor tilts it, about its centre.
  Eigen::Matrix3d tilt_W() const {
    return GrooveTilt(options_.grooves, center_W_m_, options_.heading_rad);
  }
  // Velocity of the centre along the heading as really driven, sign included.
  double true_speed_m_s() const { return true_speed_m_s_; }
  double true_turn_rate_rad_s() const;
  double radius_m() const { return options_.radius_m; }
  // Obstacles within reach of the rim, as of now.
  const std::vector<DiscContact>& contacts() const { return contacts_; }

 private:
  static size_t Index(Servo servo) { return static_cast<size_t>(servo); }
  const TrapezoidAxis& axis(Servo servo) const { return axes_[Index(servo)]; }
  TrapezoidAxis& axis(Servo servo) { return axes_[Index(servo)]; }
  double HoldDeceleration(Servo servo) const;
  void StepAngles(double dt_s);
  void StepTranslation(double dt_s);
  // The motion left of `step_W_m` after every obstacle touched has taken its part.
  Eigen::Vector2d Unobstructed(const Eigen::Vector2d& step_W_m) const;

  SynchroDriveOptions options_;
  const Surroundings* surroundings_;
  std::array<TrapezoidAxis, 3> axes_;
  std::array<double, 3> accelerations_;
  std::array<double, 3> speeds_;
  Eigen::Vector2d odometry_m_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d center_W_m_;
  bool turret_tied_ = false;
  double heading_W_rad_;
  double turret_W_rad_;
  double true_speed_m_s_ = 0.0;
  std::vector<DiscContact> contacts_;
};

}  // namespace geon::sim
