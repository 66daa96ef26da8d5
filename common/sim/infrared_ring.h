#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/angles.h"
#include "sim/noise_source.h"
#include "sim/ring_pose.h"
#include "sim/surroundings.h"

namespace geon::sim {

struct InfraredRingOptions {
  double ring_radius_m = 0.225;
  double height_m = 0.35;
  double reach_m = 0.6;
  double half_power_distance_m = 0.2;  // where the reflected light has fallen to half
  double half_cone_rad = RadiansFromDegrees(10.0);
  double noise_levels = 0.3;  // standard deviation, in steps of the 16
  double period_s = 0.05;
};

// Sixteen infrared proximity sensors on the turret: 0 nothing to 15 a bright surface at hand. How
// much comes back depends on the surface as well as on its distance.
class InfraredRing {
 public:
  static constexpr int kCount = 16;
  static constexpr int kBrightest = 15;

  // `surroundings` outlives the ring.
  InfraredRing(const InfraredRingOptions& options, uint64_t seed, const Surroundings* surroundings);

  void Advance(double time_s, const RingPose& pose);
  // `history` tenths of a reading are the reading before it, 0 to 10; sensors not in `order` read
  // 0.
  void Configure(int history, const std::vector<uint8_t>& order);
  void PowerCycle();

  std::array<uint8_t, kCount> levels() const;

 private:
  double Sample(int sensor, const RingPose& pose);

  InfraredRingOptions options_;
  NoiseSource noise_;
  const Surroundings* surroundings_;
  std::array<bool, kCount> enabled_{};
  int history_ = 0;
  std::array<double, kCount> readings_{};
  double next_sample_s_ = 0.0;
};

}  // namespace geon::sim
