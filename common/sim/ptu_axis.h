#pragma once

#include "sim/trapezoid_axis.h"

namespace geon::sim {

// What an axis of the pan-tilt unit is told to keep (hardware card 1.2 and 1.4), in motor counts.
struct PtuAxisSettings {
  double speed = 1000.0;
  double acceleration = 2000.0;
  double base_speed = 57.0;
  double upper_speed = 2902.0;
  double lower_speed = 31.0;
  char hold_power = 'R';  // R regular, L low, O off
  char move_power = 'R';  // H high, R regular, L low
};

// A stepper axis: a counter that believes every step was made, and the shaft that made them. They
// part when the shaft meets its hard stop or is held, and stay apart until the axis is reset.
class PtuAxis {
 public:
  // Soft bounds in counts; the hard stops lie `stop_margin` beyond them.
  PtuAxis(double minimum, double maximum, double stop_margin);

  // Settings are taken over by the next motion, `speed` by the present one too.
  PtuAxisSettings settings;

  void MoveTo(double position);
  // Velocity mode: runs towards the bound on that side, and stops there.
  void RunTowardsBound(double velocity, bool limits_enabled);
  void Halt();
  // Takes up a changed settings.speed in mid-motion.
  void ChangeSpeed();
  void Step(double dt_s);

  // Drives into a hard stop at `speed` to find it; done when hunting() is false again.
  void HuntStop(bool maximum, double speed);
  bool hunting() const { return hunting_; }
  // The shaft's true angle becomes the counter's: the end of a reset.
  void Reference();
  // The counter starts at 0 wherever the shaft stands: switched on without a reset.
  void ForgetPosition();
  // Something holds the shaft back: it loses `counts` steps.
  void LoseSteps(double counts);

  double position() const { return servo_.position(); }
  double velocity() const { return servo_.velocity(); }
  double target() const { return servo_.target(); }
  bool moving() const { return servo_.moving(); }
  double minimum() const { return minimum_; }
  double maximum() const { return maximum_; }
  double shaft() const { return servo_.position() - slip_; }
  // True once for each time the shaft ran into a hard stop.
  bool TakeLimitHit();

 private:
  double StopBeyond(bool maximum) const;

  double minimum_;
  double maximum_;
  double stop_margin_;
  TrapezoidAxis servo_;
  double slip_ = 0.0;  // counter minus shaft
  bool at_stop_ = false;
  bool limit_hit_ = false;
  bool hunting_ = false;
};

}  // namespace geon::sim
