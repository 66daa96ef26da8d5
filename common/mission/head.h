#pragma once

#include <cstdint>
#include <optional>

#include "active_vision/head_angles.h"
#include "sensor/ptu.h"

namespace geon::mission {

// The wish where the head shall look. Desired state: the command is repeated until the PTU echoes
// it, and now and then after that, since a PTU that was replaced or restarted knows nothing of it.
class Head {
 public:
  // Ids of commands count up from `first_id`, so that a restarted planner is not taken for the old
  // one.
  explicit Head(int64_t first_id) : id_(first_id) {}

  // `speed_rad_s` of the axis that turns: 0 for the PTU's own.
  void Point(const active_vision::HeadAngles& angles, double speed_rad_s = 0.0);
  // Points there unless it is told to look within `off_rad` of it, in both axes, already: for what
  // moves a little all the time.
  void Keep(const active_vision::HeadAngles& angles, double off_rad);
  const std::optional<active_vision::HeadAngles>& wanted() const { return wanted_; }

  // Whether the PTU stands still where it was told to, since `settle_s` at least.
  bool Settled(double now_s, const sensor::PtuState& state, double settle_s);

  // What to send now, if anything.
  std::optional<sensor::PtuCommand> Command(double now_s, const sensor::PtuState& state);

 private:
  bool Arrived(const sensor::PtuState& state) const;

  int64_t id_;
  std::optional<active_vision::HeadAngles> wanted_;
  double speed_rad_s_ = 0.0;
  std::optional<double> still_since_s_;
  double sent_s_ = -1e9;
};

}  // namespace geon::mission
