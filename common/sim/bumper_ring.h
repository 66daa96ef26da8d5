#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/angles.h"
#include "sim/noise_source.h"
#include "sim/surroundings.h"

namespace geon::sim {

struct BumperRingOptions {
  double offset_rad = 0.0;  // of bumper 0 from the base's own x axis
  double travel_m = 0.001;  // a contact closer than this closes the switch
  double overlap_rad =
      RadiansFromDegrees(4.0);   // so near its end a strip presses its neighbour too
  double chatter_min_s = 0.010;  // how long a switch bounces when it closes or opens
  double chatter_max_s = 0.030;
  std::optional<int> stuck;  // this switch is always closed
};

// Twenty switches around the base, each 18 degrees wide; the base does not turn with the steering.
class BumperRing {
 public:
  static constexpr int kCount = 20;

  BumperRing(const BumperRingOptions& options, uint64_t seed);

  // `base_W_rad` is the direction of the base's x axis; contacts are as SynchroDrive tells them.
  void Advance(double time_s, const std::vector<DiscContact>& contacts, double base_W_rad);

  // As the robot reads them at this instant, bounces included. Bit i is bumper i.
  uint32_t mask() const { return mask_; }
  // The truth behind the bounces.
  bool any_pressed() const;

 private:
  struct Switch {
    bool touched = false;
    bool reads = false;
    double bounces_until_s = 0.0;
    double next_bounce_s = 0.0;
  };

  BumperRingOptions options_;
  NoiseSource noise_;
  std::array<Switch, kCount> switches_{};
  uint32_t mask_ = 0;
  bool quiet_ = false;  // nothing touches, nothing bounces
};

}  // namespace geon::sim
