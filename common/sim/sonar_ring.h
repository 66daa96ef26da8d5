#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/noise_source.h"
#include "sim/ring_pose.h"
#include "sim/sonar_echo.h"
#include "sim/surroundings.h"

namespace geon::sim {

struct DeadSonar {
  int index = 0;
  int reading_in = 255;  // what it says for ever: 255 (mute) or 17 (deaf to all but itself)
};

struct SonarRingOptions {
  double ring_radius_m = 0.225;
  double height_m = 0.55;
  SonarEchoOptions echo;
  double sigma_1 = 0.01;  // of the range, but at least half an inch
  // Too near a wall the first echo is missed, and the second or third is heard as often as this.
  double multiple_echo_probability_1 = 0.8;
  // How much a ping's loudness differs from the next one's: standard deviation of its logarithm.
  // This and the next three are set by a real ring's log (tests/real_data/sonar_log_test.cc). Of
  // its readings between two before and two after that agree, 0.4 % are silent, 0.35 % too far, 0.2
  // % too near.
  double fading_1 = 0.55;
  double deaf_probability_1 = 0.004;       // hears nothing
  double specular_probability_1 = 0.0035;  // misses what is there, hears something farther away
  double crosstalk_probability_1 = 0.003;  // hears what the sonar fired before it sent
  double tick_s = 0.004;                   // unit of the firing rate
  int rate = 15;                           // ticks between firings
  std::array<uint8_t, 16> order = {0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8};
  std::vector<DeadSonar> dead;
};

// Sixteen Polaroid rangers on the turret, fired one after another; each keeps its last reading
// until its turn comes again (hardware card 5). What a ping hears is SonarEcho_m's; here are the
// order of firing, noise and misreadings. Readings are whole inches from 17 (the blanking time) to
// 255 (none).
class SonarRing {
 public:
  static constexpr int kCount = 16;
  static constexpr int kNearest_in = 17;
  static constexpr int kNoEcho_in = 255;

  // `surroundings` outlives the ring.
  SonarRing(const SonarRingOptions& options, uint64_t seed, const Surroundings* surroundings);

  // Fires what is due by `time_s`; called at every tick of the robot's clock.
  void Advance(double time_s, const RingPose& pose);
  // Firing order until a 255, and ticks between firings; an empty order stops the ring.
  void Configure(int rate, const std::vector<uint8_t>& order, double time_s);
  // As switched on at `time_s`: nothing heard yet, default order.
  void PowerCycle(double time_s);

  const std::array<uint8_t, kCount>& readings_in() const { return readings_in_; }

 private:
  uint8_t Ping(int sensor, const RingPose& pose);

  SonarRingOptions options_;
  NoiseSource noise_;
  const Surroundings* surroundings_;
  std::array<uint8_t, kCount> readings_in_{};
  std::vector<uint8_t> order_;
  int rate_ = 15;
  size_t next_ = 0;
  double next_firing_s_ = 0.0;
};

}  // namespace geon::sim
