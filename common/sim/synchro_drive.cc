#include "sim/synchro_drive.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::sim {
namespace {

// A wall met within 30 degrees of its normal holds the robot by friction.
constexpr double kStickingShare_1 = 0.5;

Eigen::Vector2d Direction(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

}  // namespace

SynchroDrive::SynchroDrive(const SynchroDriveOptions& options, const Surroundings* surroundings)
    : options_(options),
      surroundings_(surroundings),
      center_W_m_(options.x_m, options.y_m),
      heading_W_rad_(options.heading_rad),
      turret_W_rad_(options.heading_rad) {
  Require(surroundings != nullptr, "SynchroDrive needs surroundings");
  Require(options.odometry_distance_scale_1 > 0.0 && options.odometry_turn_scale_1 > 0.0,
          "odometry scales must be positive");
  PowerCycle();
}

void SynchroDrive::PowerCycle() {
  axes_ = {};
  turret_tied_ = false;
  odometry_m_.setZero();
  true_speed_m_s_ = 0.0;
  accelerations_ = {options_.max_acceleration_m_s2, options_.max_turn_acceleration_rad_s2,
                    options_.max_turn_acceleration_rad_s2};
  speeds_ = {options_.max_speed_m_s, options_.max_turn_rate_rad_s, options_.max_turn_rate_rad_s};
  contacts_ = surroundings_->ContactsOfDisc(center_W_m_, options_.radius_m);
}

void SynchroDrive::SetAcceleration(Servo servo, double acceleration) {
  const double limit = servo == Servo::kTranslation ? options_.max_acceleration_m_s2
                                                    : options_.max_turn_acceleration_rad_s2;
  // A servo asked for no acceleration at all still creeps: it must be able to stop.
  accelerations_[Index(servo)] = std::clamp(std::abs(acceleration), 0.02 * limit, limit);
}

void SynchroDrive::SetSpeed(Servo servo, double speed) {
  const double limit =
      servo == Servo::kTranslation ? options_.max_speed_m_s : options_.max_turn_rate_rad_s;
  speeds_[Index(servo)] = std::clamp(std::abs(speed), 0.005 * limit, limit);
}

void SynchroDrive::RunAt(Servo servo, double velocity) {
  const double limit =
      servo == Servo::kTranslation ? options_.max_speed_m_s : options_.max_turn_rate_rad_s;
  axis(servo).RunAt(std::clamp(velocity, -limit, limit), accelerations_[Index(servo)]);
}

void SynchroDrive::MoveBy(Servo servo, double distance) {
  MoveTo(servo, position(servo) + distance);
}

void SynchroDrive::MoveTo(Servo servo, double target) {
  axis(servo).MoveTo(target, speeds_[Index(servo)], accelerations_[Index(servo)]);
}

double SynchroDrive::HoldDeceleration(Servo servo) const {
  return servo == Servo::kTranslation ? options_.hold_deceleration_m_s2
                                      : options_.hold_turn_deceleration_rad_s2;
}

void SynchroDrive::Hold(Servo servo) { axis(servo).RunAt(0.0, HoldDeceleration(servo)); }

void SynchroDrive::Limp(Servo servo) { axis(servo).RunAt(0.0, 0.5 * HoldDeceleration(servo)); }

void SynchroDrive::TieTurret(bool tied) {
  if (tied || turret_tied_) axis(Servo::kTurret).Stop();
  turret_tied_ = tied;
}

void SynchroDrive::DefineAngle(Servo servo, double angle_rad) {
  Require(servo != Servo::kTranslation, "the translation has no angle");
  axis(servo).Redefine(angle_rad);
}

double SynchroDrive::true_turn_rate_rad_s() const {
  return velocity(Servo::kSteering) / options_.odometry_turn_scale_1;
}

void SynchroDrive::Step(double dt_s) {
  StepAngles(dt_s);
  StepTranslation(dt_s);
}

void SynchroDrive::StepAngles(double dt_s) {
  const double steering_before_rad = position(Servo::kSteering);
  const double turret_before_rad = position(Servo::kTurret);
  axis(Servo::kSteering).Step(dt_s);
  if (turret_tied_) {
    axis(Servo::kTurret)
        .Obstruct(turret_before_rad + position(Servo::kSteering) - steering_before_rad,
                  velocity(Servo::kSteering));
  } else {
    axis(Servo::kTurret).Step(dt_s);
  }
  heading_W_rad_ +=
      (position(Servo::kSteering) - steering_before_rad) / options_.odometry_turn_scale_1;
  turret_W_rad_ += (position(Servo::kTurret) - turret_before_rad) / options_.odometry_turn_scale_1;
}

void SynchroDrive::StepTranslation(double dt_s) {
  TrapezoidAxis& wheels = axis(Servo::kTranslation);
  const double before_m = wheels.position();
  wheels.Step(dt_s);
  const double asked_m = (wheels.position() - before_m) / options_.odometry_distance_scale_1;
  true_speed_m_s_ = 0.0;
  if (asked_m == 0.0) return;

  const Eigen::Vector2d forward_W = Direction(heading_W_rad_);
  const Eigen::Vector2d moved_W_m = Unobstructed(asked_m * forward_W);
  if (moved_W_m.isZero(0.0)) wheels.Obstruct(before_m, 0.0);
  center_W_m_ += moved_W_m;
  true_speed_m_s_ = moved_W_m.dot(forward_W) / dt_s;
  odometry_m_ += (wheels.position() - before_m) * Direction(position(Servo::kSteering));
  contacts_ = surroundings_->ContactsOfDisc(center_W_m_, options_.radius_m);
}

Eigen::Vector2d SynchroDrive::Unobstructed(const Eigen::Vector2d& step_W_m) const {
  Eigen::Vector2d left_W_m = step_W_m;
  for (const DiscContact& contact : contacts_) {
    if (contact.clearance_m > 0.0) continue;
    const Eigen::Vector2d into_W = Direction(contact.bearing_rad);
    left_W_m -= std::max(0.0, left_W_m.dot(into_W)) * into_W;
  }
  if (left_W_m.norm() < kStickingShare_1 * step_W_m.norm()) return Eigen::Vector2d::Zero();
  // In a corner, sliding along one wall may lead into the other.
  for (const DiscContact& contact : contacts_) {
    if (contact.clearance_m <= 0.0 && left_W_m.dot(Direction(contact.bearing_rad)) > 1e-12) {
      return Eigen::Vector2d::Zero();
    }
  }
  return left_W_m;
}

}  // namespace geon::sim
