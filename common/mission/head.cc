#include "mission/head.h"

#include <cmath>

namespace geon::mission {

namespace {

constexpr double kRepeat_s = 0.2;       // until the PTU has heard
constexpr double kRemind_s = 1.0;       // afterwards
constexpr double kArrived_rad = 0.003;  // three motor steps of 0.9 mrad

}  // namespace

void Head::Point(const active_vision::HeadAngles& angles, double speed_rad_s) {
  if (wanted_ && *wanted_ == angles && speed_rad_s_ == speed_rad_s) return;
  wanted_ = angles;
  speed_rad_s_ = speed_rad_s;
  ++id_;
  still_since_s_.reset();
  sent_s_ = -1e9;
}

void Head::Keep(const active_vision::HeadAngles& angles, double off_rad) {
  if (wanted_ && std::abs(wanted_->pan_rad - angles.pan_rad) < off_rad &&
      std::abs(wanted_->tilt_rad - angles.tilt_rad) < off_rad) {
    return;
  }
  Point(angles);
}

bool Head::Arrived(const sensor::PtuState& state) const {
  return wanted_ && state.status == sensor::DeviceStatus::kReady && state.command_id == id_ &&
         !state.moving && std::abs(state.pan_rad - wanted_->pan_rad) < kArrived_rad &&
         std::abs(state.tilt_rad - wanted_->tilt_rad) < kArrived_rad;
}

bool Head::Settled(double now_s, const sensor::PtuState& state, double settle_s) {
  if (!Arrived(state)) {
    still_since_s_.reset();
    return false;
  }
  if (!still_since_s_) still_since_s_ = now_s;
  return now_s - *still_since_s_ >= settle_s;
}

std::optional<sensor::PtuCommand> Head::Command(double now_s, const sensor::PtuState& state) {
  if (!wanted_) return std::nullopt;
  const double period_s = state.command_id == id_ ? kRemind_s : kRepeat_s;
  if (now_s - sent_s_ < period_s) return std::nullopt;
  sent_s_ = now_s;
  sensor::PtuCommand command;
  command.command_id = id_;
  command.pan_rad = wanted_->pan_rad;
  command.tilt_rad = wanted_->tilt_rad;
  command.speed_rad_s = speed_rad_s_;
  return command;
}

}  // namespace geon::mission
