#include "sim/ptu_axis.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geon::sim {

PtuAxis::PtuAxis(double minimum, double maximum, double stop_margin)
    : minimum_(minimum), maximum_(maximum), stop_margin_(stop_margin) {
  servo_.set_start_speed(settings.base_speed);
}

void PtuAxis::MoveTo(double position) {
  servo_.set_start_speed(settings.base_speed);
  servo_.MoveTo(position, settings.speed, settings.acceleration);
}

void PtuAxis::RunTowardsBound(double velocity, bool limits_enabled) {
  if (velocity == 0.0) {
    Halt();
    return;
  }
  const bool up = velocity > 0.0;
  const double bound = limits_enabled ? (up ? maximum_ : minimum_) : StopBeyond(up);
  servo_.set_start_speed(settings.base_speed);
  servo_.MoveTo(bound, std::abs(velocity), settings.acceleration);
}

void PtuAxis::Halt() { servo_.RunAt(0.0, settings.acceleration); }

void PtuAxis::ChangeSpeed() {
  if (servo_.moving()) MoveTo(servo_.target());
}

double PtuAxis::StopBeyond(bool maximum) const {
  // Past the stop as the counter sees it, so that the shaft is sure to meet it.
  const double stop = maximum ? maximum_ + stop_margin_ : minimum_ - stop_margin_;
  return stop + slip_ + (maximum ? 1.0 : -1.0);
}

void PtuAxis::Step(double dt_s) {
  servo_.Step(dt_s);
  const double lowest = minimum_ - stop_margin_;
  const double highest = maximum_ + stop_margin_;
  const double inside = std::clamp(shaft(), lowest, highest);
  const bool pushes = inside != shaft();
  if (pushes) {
    slip_ = servo_.position() - inside;
    if (!at_stop_) limit_hit_ = true;
    if (hunting_) {
      servo_.Stop();
      hunting_ = false;
    }
  }
  at_stop_ = pushes || (at_stop_ && (inside == lowest || inside == highest));
}

void PtuAxis::HuntStop(bool maximum, double speed) {
  hunting_ = true;
  at_stop_ = false;
  servo_.set_start_speed(settings.base_speed);
  // Far enough to reach the stop from anywhere, whatever the counter believes.
  const double travel = 2.0 * (maximum_ - minimum_ + 2.0 * stop_margin_);
  servo_.MoveTo(servo_.position() + (maximum ? travel : -travel), speed, 4.0 * speed);
}

void PtuAxis::Reference() {
  servo_.Redefine(shaft());
  slip_ = 0.0;
}

void PtuAxis::ForgetPosition() {
  const double where = shaft();
  servo_.Stop();
  servo_.Redefine(0.0);
  slip_ = -where;
  hunting_ = false;
}

void PtuAxis::LoseSteps(double counts) {
  slip_ += counts;
  limit_hit_ = true;
}

bool PtuAxis::TakeLimitHit() { return std::exchange(limit_hit_, false); }

}  // namespace geon::sim
