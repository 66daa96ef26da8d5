#include "sim/infrared_ring.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::sim {

InfraredRing::InfraredRing(const InfraredRingOptions& options, uint64_t seed,
                           const Surroundings* surroundings)
    : options_(options), noise_(seed), surroundings_(surroundings) {
  Require(surroundings != nullptr, "InfraredRing needs surroundings");
  PowerCycle();
}

void InfraredRing::PowerCycle() {
  enabled_.fill(true);
  history_ = 0;
  readings_.fill(0.0);
}

void InfraredRing::Configure(int history, const std::vector<uint8_t>& order) {
  history_ = std::clamp(history, 0, 10);
  enabled_.fill(false);
  for (const uint8_t sensor : order) {
    if (sensor >= kCount) break;
    enabled_[sensor] = true;
  }
}

void InfraredRing::Advance(double time_s, const RingPose& pose) {
  if (time_s < next_sample_s_) return;
  next_sample_s_ = time_s + options_.period_s;
  for (size_t i = 0; i < kCount; ++i) {
    const double sample = enabled_[i] ? Sample(static_cast<int>(i), pose) : 0.0;
    readings_[i] += (1.0 - 0.1 * history_) * (sample - readings_[i]);
  }
}

double InfraredRing::Sample(int sensor, const RingPose& pose) {
  const geometry::RigidTransform X_WS =
      RingSensorPose(pose, sensor, kCount, options_.ring_radius_m, options_.height_m);
  double light_1 = 0.0;
  for (const double side : {-1.0, 0.0, 1.0}) {
    const double off_axis_rad = side * options_.half_cone_rad;
    const auto hit = surroundings_->CastRay(
        X_WS.translation(),
        X_WS.linear() * Eigen::Vector3d(std::cos(off_axis_rad), std::sin(off_axis_rad), 0.0),
        options_.reach_m);
    if (!hit || hit->distance_m > options_.reach_m) continue;
    const double spread_1 = hit->distance_m / options_.half_power_distance_m;
    light_1 = std::max(light_1, hit->reflectance_1 / (1.0 + spread_1 * spread_1));
  }
  if (light_1 == 0.0) return 0.0;
  // A surface of reflectance 0.8 at hand is as bright as the scale goes.
  const double level = light_1 / 0.8 * kBrightest + options_.noise_levels * noise_.Gaussian();
  return std::clamp(level, 0.0, static_cast<double>(kBrightest));
}

std::array<uint8_t, InfraredRing::kCount> InfraredRing::levels() const {
  std::array<uint8_t, kCount> levels{};
  for (size_t i = 0; i < kCount; ++i) {
    if (enabled_[i]) levels[i] = static_cast<uint8_t>(std::lround(readings_[i]));
  }
  return levels;
}

}  // namespace geon::sim
