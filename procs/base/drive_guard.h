#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "sensor/base.h"
#include "sensor/laser_state.h"

namespace geon::base {

struct DriveGuardOptions {
  // A command is obeyed so long after its arrival. Braking from 0.4 m/s takes another 0.27 s: a
  // robot whose planner died stands within 0.5 s.
  double command_lifetime_s = 0.15;
  double state_lifetime_s = 0.3;  // and taken only in answer to a state published so recently
  double release_s = 0.1;         // a bumper counts as free after so long without contact
  double speed_limit_m_s = 0.5;
  double turn_rate_limit_rad_s = 1.0471975511965976;  // 60 degrees/s
};

// What the drive shall do now: these velocities, or (both zero) stand; and, where that is not what
// was asked, why.
struct DriveDecision {
  double speed_m_s = 0.0;
  double turn_rate_rad_s = 0.0;
  sensor::BaseStop stop = sensor::BaseStop::kNone;
  bool moves() const { return speed_m_s != 0.0 || turn_rate_rad_s != 0.0; }
};

// Decides whether the base may drive. No clock: every call takes the time, of one monotonic clock,
// never running backwards. The rules:
//
// - A command names the base state it answers (state_seq). It is taken only if that state was
// published
//   by this process, at most state_lifetime_s ago by our own clock: the link may be slow, stuck or
//   one-way, and no clock is shared. A state_seq refused once stays refused, and repeated or
//   overtaken commands (seq not growing) are no news. A command lives command_lifetime_s.
// - A bumper that is hit stops the drive and voids the command. The contact is remembered until the
//   bumper is free again and somebody who knows of it (answers a state published since) has moved
//   away from it or turned. Until then only commands that do not push towards it are obeyed:
//   turning on the spot (the base itself does not turn), and driving with the contact behind.
// - No drive while a laser burns or may burn, nor while the device is not ready; a device that was
// lost
//   needs a new command.
// - Speeds are clamped to the limits.
class DriveGuard {
 public:
  using Contacts = std::array<bool, sensor::kBumperCount>;
  using Bearings = std::array<double, sensor::kBumperCount>;

  explicit DriveGuard(const DriveGuardOptions& options = {});

  void StatePublished(double time_s, int32_t seq);
  void CommandArrived(double time_s, const sensor::BaseCommand& command);
  // `bearing_rad` is where each bumper is in R, now.
  void BumpersRead(double time_s, const Contacts& pressed, const Bearings& bearing_rad);
  void LasersReported(const sensor::LaserState& lasers);
  void DeviceReady(bool ready);

  DriveDecision Decide(double time_s) const;

  // Of the newest command taken; 0 when there was none.
  int64_t command_id() const { return command_id_; }
  // Pressed, or not yet free for release_s: contacts without their chatter.
  const Contacts& contacts() const { return contacts_; }
  // Times a bumper went from free to pressed.
  int contact_count() const { return contact_count_; }

 private:
  struct Published {
    int32_t seq;
    double time_s;
  };
  struct Taken {
    double arrival_s;
    double state_s;  // when the state it answers was published
    double speed_m_s;
    double turn_rate_rad_s;
    bool moves() const { return speed_m_s != 0.0 || turn_rate_rad_s != 0.0; }
  };

  std::optional<double> PublicationTime(double time_s, int32_t seq) const;
  bool PushesAgainst(size_t bumper, double speed_m_s) const;
  bool PushesAgainstContact(double speed_m_s) const;
  bool AnyLatched() const;
  void ForgetContacts(double speed_m_s);

  DriveGuardOptions options_;
  std::deque<Published> published_;
  std::optional<Taken> command_;
  int64_t command_id_ = 0;
  std::optional<int32_t> last_seq_;  // of the newest command taken
  int64_t last_utime_ = 0;
  double last_arrival_s_ = 0.0;
  std::optional<int32_t> refused_state_seq_;
  std::optional<double> refused_s_;
  Contacts contacts_{};
  Contacts latched_{};
  std::array<double, sensor::kBumperCount> last_touch_s_{};
  Bearings bearing_rad_{};
  double hit_s_ = 0.0;
  int contact_count_ = 0;
  bool laser_may_burn_ = false;
  bool ready_ = false;
};

}  // namespace geon::base
