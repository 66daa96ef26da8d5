#include "procs/base/drive_guard.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::base {
namespace {

using sensor::BaseStop;

// A contact is pushed against unless it is this far behind the sideways direction (about 12
// degrees).
constexpr double kBehind_1 = -0.2;

}  // namespace

DriveGuard::DriveGuard(const DriveGuardOptions& options) : options_(options) {
  Require(options.command_lifetime_s > 0.0 && options.state_lifetime_s > 0.0 &&
              options.release_s >= 0.0 && options.speed_limit_m_s > 0.0 &&
              options.turn_rate_limit_rad_s > 0.0,
          "DriveGuardOptions: times and limits must be positive");
}

void DriveGuard::StatePublished(double time_s, int32_t seq) {
  published_.push_back({seq, time_s});
  while (time_s - published_.front().time_s > options_.state_lifetime_s) published_.pop_front();
}

std::optional<double> DriveGuard::PublicationTime(double time_s, int32_t seq) const {
  for (const Published& state : published_) {
    if (state.seq != seq) continue;
    if (time_s - state.time_s > options_.state_lifetime_s) return std::nullopt;
    return state.time_s;
  }
  return std::nullopt;
}

void DriveGuard::CommandArrived(double time_s, const sensor::BaseCommand& command) {
  if (!ready_ || !std::isfinite(command.speed_m_s) || !std::isfinite(command.turn_rate_rad_s))
    return;
  if (last_seq_ && command.seq <= *last_seq_) {
    // Overtaken, unless its sender started anew: later by its own clock, and after a pause.
    const bool pause = time_s - last_arrival_s_ > options_.command_lifetime_s;
    if (!pause || command.utime <= last_utime_) return;
  }
  const std::optional<double> state_s = PublicationTime(time_s, command.state_seq);
  if (!state_s || command.state_seq == refused_state_seq_) {
    refused_state_seq_ = command.state_seq;
    refused_s_ = time_s;
    return;
  }
  refused_s_.reset();
  last_seq_ = command.seq;
  last_utime_ = command.utime;
  last_arrival_s_ = time_s;
  command_id_ = command.command_id;
  command_ =
      Taken{time_s, *state_s,
            std::clamp(command.speed_m_s, -options_.speed_limit_m_s, options_.speed_limit_m_s),
            std::clamp(command.turn_rate_rad_s, -options_.turn_rate_limit_rad_s,
                       options_.turn_rate_limit_rad_s)};
  if (command_->state_s > hit_s_ && command_->moves()) ForgetContacts(command_->speed_m_s);
}

void DriveGuard::BumpersRead(double time_s, const Contacts& pressed, const Bearings& bearing_rad) {
  bearing_rad_ = bearing_rad;
  for (size_t i = 0; i < pressed.size(); ++i) {
    if (pressed[i]) {
      last_touch_s_[i] = time_s;
      if (!contacts_[i]) ++contact_count_;
      contacts_[i] = true;
      if (latched_[i]) continue;
      latched_[i] = true;
      hit_s_ = time_s;
      command_.reset();
    } else if (time_s - last_touch_s_[i] >= options_.release_s) {
      contacts_[i] = false;
    }
  }
}

// Those that are free and are being left.
void DriveGuard::ForgetContacts(double speed_m_s) {
  for (size_t i = 0; i < latched_.size(); ++i) {
    latched_[i] = latched_[i] && (contacts_[i] || PushesAgainst(i, speed_m_s));
  }
}

bool DriveGuard::AnyLatched() const {
  return std::any_of(latched_.begin(), latched_.end(), [](bool latched) { return latched; });
}

bool DriveGuard::PushesAgainst(size_t bumper, double speed_m_s) const {
  if (speed_m_s == 0.0) return false;
  const double heading_rad = speed_m_s > 0.0 ? 0.0 : kPi;
  return std::cos(bearing_rad_[bumper] - heading_rad) > kBehind_1;
}

bool DriveGuard::PushesAgainstContact(double speed_m_s) const {
  for (size_t i = 0; i < latched_.size(); ++i) {
    if (latched_[i] && PushesAgainst(i, speed_m_s)) return true;
  }
  return false;
}

void DriveGuard::LasersReported(const sensor::LaserState& lasers) {
  if (lasers.laser != sensor::Laser::kNone) {
    laser_may_burn_ = true;
  } else if (lasers.status == sensor::DeviceStatus::kReady) {
    laser_may_burn_ = false;
  }
}

void DriveGuard::DeviceReady(bool ready) {
  ready_ = ready;
  if (!ready) command_.reset();
}

DriveDecision DriveGuard::Decide(double time_s) const {
  const bool fresh = command_ && time_s - command_->arrival_s <= options_.command_lifetime_s;
  if (!ready_) return {.stop = BaseStop::kDeviceLost};
  if (AnyLatched() &&
      (!fresh || command_->state_s <= hit_s_ || PushesAgainstContact(command_->speed_m_s))) {
    return {.stop = BaseStop::kBumper};
  }
  if (laser_may_burn_) return {.stop = BaseStop::kLaserOn};
  if (fresh) return {command_->speed_m_s, command_->turn_rate_rad_s, BaseStop::kNone};
  if (refused_s_ && time_s - *refused_s_ <= options_.command_lifetime_s) {
    return {.stop = BaseStop::kStaleCommand};
  }
  return {.stop = command_ && command_->moves() ? BaseStop::kCommandExpired : BaseStop::kNone};
}

}  // namespace geon::base
