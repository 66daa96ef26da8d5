#include "sim/trapezoid_axis.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::sim {

void TrapezoidAxis::MoveTo(double target, double speed, double acceleration) {
  Require(speed > 0.0 && acceleration > 0.0, "speed and acceleration must be positive");
  seeks_position_ = true;
  target_ = target;
  speed_ = speed;
  acceleration_ = acceleration;
  wanted_velocity_ = 0.0;
}

void TrapezoidAxis::RunAt(double velocity, double acceleration) {
  Require(acceleration > 0.0, "acceleration must be positive");
  seeks_position_ = false;
  wanted_velocity_ = velocity;
  acceleration_ = acceleration;
}

void TrapezoidAxis::Stop() {
  seeks_position_ = false;
  velocity_ = 0.0;
  wanted_velocity_ = 0.0;
}

void TrapezoidAxis::Redefine(double position) {
  target_ += position - position_;
  position_ = position;
}

void TrapezoidAxis::Obstruct(double position, double velocity) {
  position_ = position;
  velocity_ = velocity;
}

void TrapezoidAxis::Step(double dt_s) {
  if (seeks_position_) {
    StepToTarget(dt_s);
  } else {
    StepToVelocity(wanted_velocity_, dt_s);
    position_ += velocity_ * dt_s;
  }
}

void TrapezoidAxis::StepToTarget(double dt_s) {
  const double remaining = target_ - position_;
  const double change = acceleration_ * dt_s;
  // The speed that can still be braked to the start speed in what remains after this step.
  const double braking_speed = std::sqrt(change * change + start_speed_ * start_speed_ +
                                         2.0 * acceleration_ * std::abs(remaining)) -
                               change;
  const double wanted = std::min(speed_, std::max(braking_speed, start_speed_));
  StepToVelocity(remaining == 0.0 ? 0.0 : std::copysign(wanted, remaining), dt_s);

  const double step = velocity_ * dt_s;
  const bool reaches =
      step * remaining >= 0.0 && std::abs(remaining) <= std::abs(step) + change * dt_s;
  if (reaches && std::abs(velocity_) <= start_speed_ + 2.0 * change) {
    position_ = target_;
    velocity_ = 0.0;
  } else {
    position_ += step;
  }
}

void TrapezoidAxis::StepToVelocity(double wanted, double dt_s) {
  // A stepper jumps to its start-up speed, and stops or reverses from it at once.
  const double jump = std::min(start_speed_, std::abs(wanted));
  const bool against = velocity_ * wanted <= 0.0;
  if (against ? std::abs(velocity_) <= start_speed_ : std::abs(velocity_) < jump) {
    velocity_ = std::copysign(jump, wanted);
  }
  const double change = acceleration_ * dt_s;
  velocity_ += std::clamp(wanted - velocity_, -change, change);
}

}  // namespace geon::sim
