#pragma once

namespace geon::sim {

// One servo: moves to a position, or runs at a velocity, with a trapezoidal speed profile. Both may
// be changed while it moves. Units are the caller's (counts, metres, radians).
//
// `start_speed` is the speed a stepper takes at once; only speed above it is ramped.
class TrapezoidAxis {
 public:
  void MoveTo(double target, double speed, double acceleration);
  void RunAt(double velocity, double acceleration);
  // Stands still at once (a stalled motor, a hit limit).
  void Stop();
  void Step(double dt_s);

  // Declares the present position to be `position` without moving; a target moves along with it.
  void Redefine(double position);
  // What an obstacle did to the last step: the axis stands here and moves so fast.
  void Obstruct(double position, double velocity);
  void set_start_speed(double speed) { start_speed_ = speed; }

  double position() const { return position_; }
  double velocity() const { return velocity_; }
  // Where it is going; its position when it is not going anywhere.
  double target() const { return seeks_position_ ? target_ : position_; }
  bool moving() const {
    return velocity_ != 0.0 || (seeks_position_ ? position_ != target_ : wanted_velocity_ != 0.0);
  }

 private:
  void StepToTarget(double dt_s);
  void StepToVelocity(double wanted, double dt_s);

  double position_ = 0.0;
  double velocity_ = 0.0;
  double start_speed_ = 0.0;
  double acceleration_ = 1.0;
  bool seeks_position_ = false;
  double target_ = 0.0;
  double speed_ = 0.0;
  double wanted_velocity_ = 0.0;
};

}  // namespace geon::sim
