#include "sim/sonar_ring.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::sim {
namespace {

constexpr double kInch_m = 0.0254;
// The fan: a dense horizontal row, sparse rows above and below it.
constexpr int kRowRays = 15;
constexpr int kSideRays = 3;
constexpr double kSideElevation_1 = 0.55;  // of the half cone
// A surface that falls back by more than this from one ray to the next has an edge between them.
constexpr double kEdgeStep_m = 0.03;

Eigen::Vector3d Unit(double bearing_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::cos(bearing_rad),
          std::cos(elevation_rad) * std::sin(bearing_rad), std::sin(elevation_rad)};
}

// The beam falls to about a tenth at the edge of the nominal cone.
double BeamStrength(double off_axis_rad, double half_cone_rad) {
  const double x = off_axis_rad / half_cone_rad;
  return std::exp(-2.3 * x * x);
}

}  // namespace

struct SonarRing::Ray {
  Eigen::Vector3d direction_W;
  double beam_1 = 0.0;
  bool in_row = false;  // of the dense row, whose neighbours are compared
  std::optional<RayHit> hit;
};

bool SonarRing::FallsBack(const Ray& ray, const Ray& neighbour) {
  if (!neighbour.hit) return true;
  const Eigen::Vector3d apart_m =
      neighbour.hit->distance_m * neighbour.direction_W - ray.hit->distance_m * ray.direction_W;
  return ray.hit->normal_W.dot(apart_m) < -kEdgeStep_m;
}

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
  const std::optional<double> echo_m = Echo_m(sensor, pose);
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

std::optional<double> SonarRing::Echo_m(int sensor, const RingPose& pose) const {
  const double bearing_rad = pose.bearing_W_rad + sensor * 2.0 * kPi / kCount;
  const Eigen::Vector2d rim_W_m =
      pose.center_W_m +
      options_.ring_radius_m * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
  const Eigen::Vector3d origin_W_m(rim_W_m.x(), rim_W_m.y(), options_.height_m);
  const std::vector<Ray> fan = CastFan(origin_W_m, bearing_rad);

  double nearest_m = kNoEcho_in * kInch_m;
  bool heard = false;
  const auto consider = [&](double range_m, double strength_1) {
    if (range_m < nearest_m && Audible(range_m, strength_1)) {
      nearest_m = range_m;
      heard = true;
    }
  };
  for (size_t i = 0; i < fan.size(); ++i) {
    const Ray& ray = fan[i];
    if (!ray.hit) continue;
    const double strength_1 = ray.beam_1 * ray.hit->reflectance_1;
    const double incidence_rad =
        std::acos(std::clamp(-ray.direction_W.dot(ray.hit->normal_W), -1.0, 1.0));
    if (incidence_rad <= options_.specular_limit_rad) consider(ray.hit->distance_m, strength_1);
    if (ray.in_row) {
      for (const size_t j : {i - 1, i + 1}) {  // i - 1 wraps round at 0 and fails the test
        if (j >= fan.size() || !fan[j].in_row) continue;
        if (FallsBack(ray, fan[j]))
          consider(ray.hit->distance_m, options_.edge_echo_1 * strength_1);
      }
    }
    if (options_.double_bounce && incidence_rad > options_.specular_limit_rad) {
      if (const auto range_m = DoubleBounce_m(origin_W_m, ray))
        consider(*range_m, 0.5 * strength_1);
    }
  }
  if (!heard) return std::nullopt;
  return nearest_m;
}

std::vector<SonarRing::Ray> SonarRing::CastFan(const Eigen::Vector3d& origin_W_m,
                                               double bearing_W_rad) const {
  std::vector<Ray> fan;
  const auto add = [&](double off_bearing_rad, double elevation_rad, bool in_row) {
    Ray ray;
    ray.direction_W = Unit(bearing_W_rad + off_bearing_rad, elevation_rad);
    ray.beam_1 = BeamStrength(std::hypot(off_bearing_rad, elevation_rad), options_.half_cone_rad);
    ray.in_row = in_row;
    ray.hit = surroundings_->CastRay(origin_W_m, ray.direction_W);
    fan.push_back(ray);
  };
  for (int i = 0; i < kRowRays; ++i) {
    add(options_.half_cone_rad * (2.0 * i / (kRowRays - 1) - 1.0), 0.0, true);
  }
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < kSideRays; ++i) {
      add(0.5 * options_.half_cone_rad * (i - 1), side * kSideElevation_1 * options_.half_cone_rad,
          false);
    }
  }
  return fan;
}

std::optional<double> SonarRing::DoubleBounce_m(const Eigen::Vector3d& origin_W_m,
                                                const Ray& ray) const {
  const auto mirror = [](const Eigen::Vector3d& direction, const Eigen::Vector3d& normal) {
    return Eigen::Vector3d(direction - 2.0 * direction.dot(normal) * normal);
  };
  const Eigen::Vector3d first_W_m =
      origin_W_m + ray.hit->distance_m * ray.direction_W + 1e-4 * ray.hit->normal_W;
  const Eigen::Vector3d onward_W = mirror(ray.direction_W, ray.hit->normal_W);
  const std::optional<RayHit> second = surroundings_->CastRay(first_W_m, onward_W);
  if (!second) return std::nullopt;
  const Eigen::Vector3d second_W_m = first_W_m + second->distance_m * onward_W;
  const Eigen::Vector3d home_W_m = origin_W_m - second_W_m;
  // The sound comes back when it leaves the second wall within the beam's width of the way home.
  const double miss_1 = mirror(onward_W, second->normal_W).dot(home_W_m.normalized());
  if (miss_1 < std::cos(options_.half_cone_rad)) return std::nullopt;
  return 0.5 * (ray.hit->distance_m + second->distance_m + home_W_m.norm());
}

bool SonarRing::Audible(double range_m, double strength_1) const {
  const double faded_1 = std::min(1.0, std::pow(options_.full_strength_range_m / range_m, 2));
  return strength_1 * faded_1 >= options_.threshold_1;
}

}  // namespace geon::sim
