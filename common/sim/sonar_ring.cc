#include "sim/sonar_ring.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::sim {
namespace {

constexpr double kInch_m = 0.0254;

}  // namespace

SonarRing::SonarRing(const SonarRingOptions& options, uint64_t seed,
                     const Surroundings* surroundings)
    : options_(options), noise_(seed), surroundings_(surroundings) {
  Require(surroundings != nullptr, "SonarRing needs surroundings");
  for (const DeadSonar& dead : options.dead) {
    Require(dead.index >= 0 && dead.index < kCount, "dead sonar index outside 0..15");
    Require(dead.reading_in >= kNearest_in && dead.reading_in <= kNoEcho_in,
            "dead sonar reading outside 17..255");
  }
  PowerCycle(0.0);
}

void SonarRing::PowerCycle(double time_s) {
  readings_in_.fill(kNoEcho_in);
  Configure(options_.rate, {options_.order.begin(), options_.order.end()}, time_s);
}

void SonarRing::Configure(int rate, const std::vector<uint8_t>& order, double time_s) {
  rate_ = std::max(1, rate);
  order_.clear();
  for (const uint8_t sensor : order) {
    if (sensor >= kCount) break;
    order_.push_back(sensor);
  }
  next_ = 0;
  next_firing_s_ = time_s + rate_ * options_.tick_s;
}

void SonarRing::Advance(double time_s, const RingPose& pose) {
  if (order_.empty() || time_s < next_firing_s_) return;
  const uint8_t sensor = order_[next_];
  next_ = (next_ + 1) % order_.size();
  next_firing_s_ += rate_ * options_.tick_s;
  readings_in_[sensor] = Ping(sensor, pose);
}

uint8_t SonarRing::Ping(int sensor, const RingPose& pose) {
  for (const DeadSonar& dead : options_.dead) {
    if (dead.index == sensor) return static_cast<uint8_t>(dead.reading_in);
  }
  const double loudness_1 = std::exp(options_.fading_1 * noise_.Gaussian());
  const geometry::RigidTransform X_WS =
      RingSensorPose(pose, sensor, kCount, options_.ring_radius_m, options_.height_m);
  const auto echo_m = SonarEcho_m(*surroundings_, X_WS, options_.echo, loudness_1);
  double range_in = echo_m ? *echo_m / kInch_m : kNoEcho_in;
  if (echo_m) {
    range_in += noise_.Gaussian() * std::max(0.5, options_.sigma_1 * range_in);
    // Too near: the transducer still rings when the first echo is back, and may hear a later one.
    if (range_in < kNearest_in) {
      const bool hears_later = noise_.Chance(options_.multiple_echo_probability_1);
      const double later_in = range_in * std::ceil(kNearest_in / std::max(range_in, 5.0));
      range_in = hears_later ? later_in : kNearest_in;
    }
  }
  if (noise_.Chance(options_.crosstalk_probability_1)) {
    range_in = noise_.Uniform(kNearest_in, std::min<double>(range_in, kNoEcho_in));
  }
  if (options_.specular_probability_1 > 0.0 && noise_.Chance(options_.specular_probability_1)) {
    range_in = noise_.Uniform(std::min<double>(range_in, kNoEcho_in), kNoEcho_in);
  }
  if (options_.deaf_probability_1 > 0.0 && noise_.Chance(options_.deaf_probability_1)) {
    range_in = kNoEcho_in;
  }
  return static_cast<uint8_t>(std::clamp<long>(std::lround(range_in), kNearest_in, kNoEcho_in));
}

}  // namespace geon::sim
