#include "sim/ptu_unit.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"

namespace geon::sim {

PtuUnit::PtuUnit(const PtuUnitOptions& options)
    : options_(options),
      axes_{PtuAxis(options.pan_minimum_counts, options.pan_maximum_counts,
                    options.stop_margin_counts),
            PtuAxis(options.tilt_minimum_counts, options.tilt_maximum_counts,
                    options.stop_margin_counts)} {}

void PtuUnit::ApplyAxisSettings() {
  for (const PtuAxisId id : kPtuAxes) axis(id).settings = axis_settings(id);
}

void PtuUnit::MoveTo(PtuAxisId id, double position) {
  if (!settings_.immediate) {
    pending_[static_cast<size_t>(id)] = position;
    return;
  }
  ApplyAxisSettings();
  axis(id).MoveTo(position);
}

double PtuUnit::Target(PtuAxisId id) const {
  return pending_[static_cast<size_t>(id)].value_or(axis(id).target());
}

void PtuUnit::ChangeSpeed(PtuAxisId id, double speed) {
  axis_settings(id).speed = speed;
  ApplyAxisSettings();
  axis(id).ChangeSpeed();
}

void PtuUnit::RunAt(PtuAxisId id, double velocity) {
  velocities_[static_cast<size_t>(id)] = velocity;
  ApplyAxisSettings();
  axis(id).RunTowardsBound(velocity, settings_.limits);
}

void PtuUnit::SetVelocityMode(bool on) {
  if (on == settings_.velocity_mode) return;
  settings_.velocity_mode = on;
  for (const PtuAxisId id : kPtuAxes) Halt(id);
}

void PtuUnit::StartPendingMoves() {
  ApplyAxisSettings();
  for (const PtuAxisId id : kPtuAxes) {
    auto& pending = pending_[static_cast<size_t>(id)];
    if (pending) axis(id).MoveTo(*pending);
    pending.reset();
  }
}

void PtuUnit::Halt(PtuAxisId id) {
  pending_[static_cast<size_t>(id)].reset();
  velocities_[static_cast<size_t>(id)] = 0.0;
  axis(id).Halt();
}

bool PtuUnit::moving() const {
  return std::any_of(axes_.begin(), axes_.end(), [](const PtuAxis& a) { return a.moving(); });
}

void PtuUnit::Restore(bool factory) {
  settings_ = factory ? PtuSettings{} : saved_;
  for (const PtuAxisId id : kPtuAxes) Halt(id);
}

void PtuUnit::StartReset(std::array<bool, 2> axes) {
  AbortMonitor();
  for (const PtuAxisId id : kPtuAxes) Halt(id);
  resets_ = axes;
  EnterResetStep(ResetStep::kTiltDown);
}

void PtuUnit::EnterResetStep(ResetStep step) {
  const auto resets = [&](PtuAxisId id) { return resets_[static_cast<size_t>(id)]; };
  if (step == ResetStep::kTiltDown && !resets(PtuAxisId::kTilt)) step = ResetStep::kPanRight;
  if (step == ResetStep::kPanRight && !resets(PtuAxisId::kPan)) step = ResetStep::kHome;
  reset_step_ = step;
  switch (step) {
    case ResetStep::kTiltDown:
    case ResetStep::kTiltUp:
      axis(PtuAxisId::kTilt).HuntStop(step == ResetStep::kTiltUp, options_.reset_speed_counts_s);
      break;
    case ResetStep::kPanRight:
    case ResetStep::kPanLeft:
      axis(PtuAxisId::kPan).HuntStop(step == ResetStep::kPanLeft, options_.reset_speed_counts_s);
      break;
    case ResetStep::kHome:
      ApplyAxisSettings();
      for (const PtuAxisId id : kPtuAxes) {
        if (!resets(id)) continue;
        axis(id).Reference();
        axis(id).MoveTo(0.0);
      }
      break;
    case ResetStep::kNone:
      break;
  }
}

void PtuUnit::StepReset() {
  switch (reset_step_) {
    case ResetStep::kNone:
      break;
    case ResetStep::kHome:
      if (!moving()) reset_step_ = ResetStep::kNone;
      break;
    default: {
      const bool tilts = reset_step_ == ResetStep::kTiltDown || reset_step_ == ResetStep::kTiltUp;
      if (axis(tilts ? PtuAxisId::kTilt : PtuAxisId::kPan).hunting()) break;
      EnterResetStep(static_cast<ResetStep>(static_cast<int>(reset_step_) + 1));
    }
  }
}

void PtuUnit::StartMonitor() {
  monitoring_ = true;
  monitor_towards_b_ = true;
}

void PtuUnit::AbortMonitor() {
  if (!monitoring_) return;
  monitoring_ = false;
  ApplyAxisSettings();
  for (const PtuAxisId id : kPtuAxes) axis(id).MoveTo(0.0);
}

void PtuUnit::StepMonitor() {
  if (!monitoring_ || moving()) return;
  ApplyAxisSettings();
  const auto& end = monitor_towards_b_ ? settings_.monitor_b : settings_.monitor_a;
  for (const PtuAxisId id : kPtuAxes) axis(id).MoveTo(end[static_cast<size_t>(id)]);
  monitor_towards_b_ = !monitor_towards_b_;
}

void PtuUnit::PowerCycle() {
  echo = verbose = true;
  monitoring_ = false;
  pending_ = {};
  velocities_ = {};
  settings_ = saved_;
  for (PtuAxis& a : axes_) a.ForgetPosition();
  StartReset(settings_.reset_at_power_up);
  if (settings_.monitor_at_power_up) StartMonitor();
}

std::string PtuUnit::Step(double dt_s) {
  for (PtuAxis& a : axes_) a.Step(dt_s);
  std::string events;
  if (axis(PtuAxisId::kTilt).TakeLimitHit()) events += "!T";
  if (axis(PtuAxisId::kPan).TakeLimitHit()) events += "!P";
  if (resetting()) {
    StepReset();
  } else {
    StepMonitor();
  }
  return events;
}

double PtuUnit::shaft_rad(PtuAxisId id) const {
  return RadiansFromDegrees(axis(id).shaft() * options_.resolution_arcsec / 3600.0);
}

}  // namespace geon::sim
