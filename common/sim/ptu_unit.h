#pragma once

#include <array>
#include <optional>
#include <string>

#include "sim/ptu_axis.h"

namespace geon::sim {

struct PtuUnitOptions {
  double resolution_arcsec = 185.1428;                           // of one count, both axes
  double pan_minimum_counts = -3090, pan_maximum_counts = 3090;  // counts, found at reset
  double tilt_minimum_counts = -907, tilt_maximum_counts = 604;
  double stop_margin_counts = 30;              // counts from a bound to the hard stop
  double highest_upper_speed_counts_s = 5833;  // counts/s: the data sheet's 300 deg/s
  double reset_speed_counts_s = 1500;          // counts/s while hunting for the stops
  double table_time_s = 0.8;        // to recompute the speed tables (xA, xB, xL, lowering xU)
  double upper_speed_time_s = 6.0;  // to raise xU
};

enum class PtuAxisId { kPan = 0, kTilt = 1 };
inline constexpr std::array<PtuAxisId, 2> kPtuAxes = {PtuAxisId::kPan, PtuAxisId::kTilt};

// What DS saves, DR restores and DF takes from the factory.
struct PtuSettings {
  std::array<PtuAxisSettings, 2> axes;
  bool limits = true;
  bool immediate = true;
  bool velocity_mode = false;
  bool monitor_at_power_up = false;
  std::array<bool, 2> reset_at_power_up = {true, true};
  int unit_id = 0;
  std::array<double, 2> monitor_a = {-2000, 0};  // counts, pan and tilt
  std::array<double, 2> monitor_b = {2000, 0};
};

// The pan-tilt unit behind its command language: two axes, its settings, and the longer jobs it
// does by itself (reset, autoscan). Positive pan turns left, positive tilt looks up.
class PtuUnit {
 public:
  explicit PtuUnit(const PtuUnitOptions& options);

  const PtuUnitOptions& options() const { return options_; }
  PtuSettings& settings() { return settings_; }
  const PtuSettings& settings() const { return settings_; }
  PtuAxis& axis(PtuAxisId id) { return axes_[static_cast<size_t>(id)]; }
  const PtuAxis& axis(PtuAxisId id) const { return axes_[static_cast<size_t>(id)]; }
  PtuAxisSettings& axis_settings(PtuAxisId id) { return settings_.axes[static_cast<size_t>(id)]; }

  bool echo = true;
  bool verbose = true;

  void MoveTo(PtuAxisId id, double position);  // now, or when told to if slaved
  // Where the axis is going, or will be going once told to.
  double Target(PtuAxisId id) const;
  void ChangeSpeed(PtuAxisId id, double speed);
  void RunAt(PtuAxisId id, double velocity);  // pure velocity mode
  double commanded_velocity(PtuAxisId id) const { return velocities_[static_cast<size_t>(id)]; }
  void SetVelocityMode(bool on);
  void StartPendingMoves();
  void Halt(PtuAxisId id);
  bool moving() const;

  void Save() { saved_ = settings_; }
  void Restore(bool factory);
  void StartReset(std::array<bool, 2> axes);
  bool resetting() const { return reset_step_ != ResetStep::kNone; }
  void StartMonitor();
  void AbortMonitor();
  bool monitoring() const { return monitoring_; }
  void PowerCycle();

  // Motion for `dt_s`; returns what happened as the unit says it: "!P", "!T", nothing.
  std::string Step(double dt_s);

  // The truth: where the head points.
  double shaft_rad(PtuAxisId id) const;

 private:
  enum class ResetStep { kNone, kTiltDown, kTiltUp, kPanRight, kPanLeft, kHome };

  void EnterResetStep(ResetStep step);
  void StepReset();
  void StepMonitor();
  void ApplyAxisSettings();

  PtuUnitOptions options_;
  PtuSettings settings_;
  PtuSettings saved_;
  std::array<PtuAxis, 2> axes_;
  std::array<std::optional<double>, 2> pending_;
  std::array<double, 2> velocities_{};
  ResetStep reset_step_ = ResetStep::kNone;
  std::array<bool, 2> resets_{};
  bool monitoring_ = false;
  bool monitor_towards_b_ = false;
};

}  // namespace geon::sim
