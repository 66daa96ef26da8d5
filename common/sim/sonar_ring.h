#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/angles.h"
#include "sim/noise_source.h"
#include "sim/surroundings.h"

namespace geon::sim {

struct DeadSonar {
  int index = 0;
  int reading_in = 255;  // what it says for ever: 255 (mute) or 17 (deaf to all but itself)
};

struct SonarRingOptions {
  double ring_radius_m = 0.225;
  double height_m = 0.55;
  double half_cone_rad = RadiansFromDegrees(15.0);
  // A smooth surface sends the sound back only when it is met this squarely.
  double specular_limit_rad = RadiansFromDegrees(22.0);
  double edge_echo_1 = 0.12;                 // strength of an edge's echo, a wall's being 1
  double full_strength_range_m = 2.0;        // beyond it echoes fade with the square of the range
  double threshold_1 = 0.02;                 // the faintest echo heard
  double sigma_1 = 0.01;                     // of the range, but at least half an inch
  bool double_bounce = true;                 // corners answer by way of both their walls
  double multiple_echo_probability_1 = 0.3;  // a wall too near is heard at its second echo
  double deaf_probability_1 = 0.0;           // hears nothing
  double specular_probability_1 = 0.0;       // misses what is there, hears something farther away
  double crosstalk_probability_1 = 0.003;    // hears what the sonar fired before it sent
  double tick_s = 0.004;                     // unit of the firing rate
  int rate = 15;                             // ticks between firings
  std::array<uint8_t, 16> order = {0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8};
  std::vector<DeadSonar> dead;
};

// Where the ring is at the moment a sonar fires.
struct RingPose {
  Eigen::Vector2d center_W_m = Eigen::Vector2d::Zero();
  double bearing_W_rad = 0.0;  // of sensor 0
};

// Sixteen Polaroid rangers on the turret, fired one after another; each keeps its last reading
// until its turn comes again (hardware card 5).
//
// A ping is a fan of rays over the cone. A ray gives an echo where it meets a surface squarely, at
// an edge (where the surface ends or bends away), and after two bounces in a corner; the nearest
// echo loud enough counts. Readings are whole inches from 17 (the blanking time) to 255 (none).
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

  // The range of the echo heard, before noise: nothing when there is none. Exposed for tests.
  std::optional<double> Echo_m(int sensor, const RingPose& pose) const;

 private:
  struct Ray;
  std::vector<Ray> CastFan(const Eigen::Vector3d& origin_W_m, double bearing_W_rad) const;
  std::optional<double> DoubleBounce_m(const Eigen::Vector3d& origin_W_m, const Ray& ray) const;
  // Whether the surface that `ray` meets ends, or bends away, before its neighbour.
  static bool FallsBack(const Ray& ray, const Ray& neighbour);
  bool Audible(double range_m, double strength_1) const;
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
