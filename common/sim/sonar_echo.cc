#include "sim/sonar_echo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace geon::sim {
namespace {

using Eigen::Vector3d;

// The fan: a row of rays across the beam, dense in the cone, and three below and above the cone's.
constexpr int kConeRays = 15;
constexpr int kLobeRays = 6;  // to either side
constexpr int kRowRays = kConeRays + 2 * kLobeRays;
constexpr int kMiddleRay = kRowRays / 2;
constexpr std::array<int, 3> kSideRays = {kMiddleRay - 4, kMiddleRay, kMiddleRay + 4};
constexpr double kSideElevation_1 = 0.55;  // of the half cone
// A surface that falls back by more than this from one ray to the next has an edge between them.
constexpr double kEdgeStep_m = 0.03;
// Met within this, what is no plane sends back some sound (half a step between the side rays).
constexpr double kSquare_rad = 0.09;
constexpr double kWavelength_m = 0.0069;  // 49.4 kHz
constexpr double kSamePlane_m = 0.002;    // two hits so near to one plane
constexpr double kSamePlane_1 = 1.0 - 1e-6;
constexpr double kSteep_1 = 0.7;  // what is less upright has no edges that answer: floor, tops

struct Ray {
  Vector3d direction_W = Vector3d::UnitX();
  double beam_1 = 0.0;
  bool in_cone = false;
  std::optional<RayHit> hit;
  double incidence_rad = 0.0;
};

class Ping {
 public:
  Ping(const Surroundings& surroundings, const geometry::RigidTransform& X_WS,
       const SonarEchoOptions& options, double loudness_1)
      : surroundings_(surroundings), X_WS_(X_WS), options_(options), loudness_1_(loudness_1) {}

  std::optional<double> NearestEcho_m() {
    std::array<Ray, kRowRays> row;
    for (int k = 0; k < kRowRays; ++k) row[static_cast<size_t>(k)] = Cast(Bearing_rad(k), 0.0);
    for (size_t k = 0; k < row.size(); ++k) {
      HearPlane(row[k]);
      HearCurve(row[k]);
      if (k > 0) HearUprightEdge(row[k], row[k - 1]);
      if (k + 1 < row.size()) HearUprightEdge(row[k], row[k + 1]);
      HearCorner(row[k]);
    }
    for (const double side : {-1.0, 1.0}) {
      for (const int k : kSideRays) {
        const Ray ray = Cast(Bearing_rad(k), side * kSideElevation_1 * options_.half_cone_rad);
        HearPlane(ray);
        HearCurve(ray);
        HearRim(ray, row[static_cast<size_t>(k)]);
        HearRim(row[static_cast<size_t>(k)], ray);
      }
    }
    return nearest_m_;
  }

 private:
  double Bearing_rad(int k) const {
    const int from_middle = k - kMiddleRay, cone_end = kConeRays / 2;
    const int beyond = std::max(0, std::abs(from_middle) - cone_end);
    const double off_rad =
        options_.half_cone_rad * (std::abs(from_middle) - beyond) / cone_end +
        (options_.side_lobe_end_rad - options_.half_cone_rad) * beyond / kLobeRays;
    return std::copysign(off_rad, from_middle);
  }

  double Beam(const Vector3d& direction_W) const {
    const double off_axis_rad =
        std::acos(std::clamp(direction_W.dot(X_WS_.linear().col(0)), -1.0, 1.0));
    if (off_axis_rad > options_.side_lobe_end_rad) return 0.0;
    const double x = off_axis_rad / options_.half_cone_rad;
    return std::max(std::exp(-2.3 * x * x), options_.side_lobe_1);
  }

  Ray Cast(double bearing_rad, double elevation_rad) const {
    Ray ray;
    ray.direction_W = X_WS_.linear() * Vector3d(std::cos(elevation_rad) * std::cos(bearing_rad),
                                                std::cos(elevation_rad) * std::sin(bearing_rad),
                                                std::sin(elevation_rad));
    ray.beam_1 = Beam(ray.direction_W);
    ray.in_cone = std::abs(bearing_rad) <= options_.half_cone_rad + 1e-9;
    ray.hit = surroundings_.CastRay(X_WS_.translation(), ray.direction_W);
    if (ray.hit) {
      ray.incidence_rad = std::acos(std::clamp(-ray.direction_W.dot(ray.hit->normal_W), -1.0, 1.0));
    }
    return ray;
  }

  void Consider(double range_m, double strength_1) {
    if (range_m > options_.reach_m * std::sqrt(strength_1 * loudness_1_)) return;
    nearest_m_ = std::min(nearest_m_.value_or(range_m), range_m);
  }

  // The foot of the perpendicular on the plane that the ray has met, if the plane is there, as far
  // as the sound needs it: to either side by the radius of the first Fresnel zone.
  void HearPlane(const Ray& ray) {
    if (!ray.hit) return;
    const Vector3d& normal_W = ray.hit->normal_W;
    const double beam_1 = Beam(-normal_W);
    const double away_m = ray.hit->distance_m * std::cos(ray.incidence_rad);
    if (beam_1 == 0.0 || away_m >= nearest_m_.value_or(1e9)) return;
    const Vector3d aside_1 =
        std::sqrt(kWavelength_m / (2.0 * away_m)) * Vector3d::UnitZ().cross(normal_W);
    for (const double side : {-1.0, 1.0}) {
      const Vector3d direction_W = (side * aside_1 - normal_W).normalized();
      const auto hit = surroundings_.CastRay(X_WS_.translation(), direction_W);
      if (!hit || hit->normal_W.dot(normal_W) < kSamePlane_1) return;
      const double hit_away_m = -hit->distance_m * direction_W.dot(normal_W);
      if (std::abs(hit_away_m - away_m) > kSamePlane_m) return;
    }
    Consider(away_m, beam_1);
  }

  void HearCurve(const Ray& ray) {
    if (!ray.hit || !ray.in_cone || ray.incidence_rad > kSquare_rad) return;
    Consider(ray.hit->distance_m, options_.scatter_1 * ray.beam_1);
  }

  // Whether the upright surface that `ray` meets ends, or bends away, before its neighbour.
  static bool FallsBack(const Ray& ray, const Ray& neighbour) {
    if (!ray.hit || std::abs(ray.hit->normal_W.z()) > kSteep_1) return false;
    if (!neighbour.hit) return true;
    const Vector3d apart_m =
        neighbour.hit->distance_m * neighbour.direction_W - ray.hit->distance_m * ray.direction_W;
    return ray.hit->normal_W.dot(apart_m) < -kEdgeStep_m;
  }

  void HearUprightEdge(const Ray& ray, const Ray& beside) {
    if (!ray.in_cone || !FallsBack(ray, beside)) return;
    Consider(ray.hit->distance_m, options_.scatter_1 * ray.beam_1);
  }

  // A level edge, like any straight one, sends back the sound that meets it squarely.
  void HearRim(const Ray& ray, const Ray& above_or_below) {
    if (!FallsBack(ray, above_or_below)) return;
    const Vector3d along_W = Vector3d::UnitZ().cross(ray.hit->normal_W);
    if (std::abs(along_W.dot(ray.direction_W)) > std::sin(kSquare_rad)) return;
    Consider(ray.hit->distance_m, options_.scatter_1 * ray.beam_1);
  }

  void HearCorner(const Ray& ray) {
    if (!ray.hit || !ray.in_cone || ray.incidence_rad <= kSquare_rad) return;
    const auto mirror = [](const Vector3d& direction, const Vector3d& normal) {
      return Vector3d(direction - 2.0 * direction.dot(normal) * normal);
    };
    const Vector3d first_W_m =
        X_WS_.translation() + ray.hit->distance_m * ray.direction_W + 1e-4 * ray.hit->normal_W;
    const Vector3d onward_W = mirror(ray.direction_W, ray.hit->normal_W);
    const auto second = surroundings_.CastRay(first_W_m, onward_W);
    if (!second) return;
    const Vector3d home_W_m = X_WS_.translation() - (first_W_m + second->distance_m * onward_W);
    // The sound comes back when it leaves the second wall within the beam's width of the way home.
    const double miss_1 = mirror(onward_W, second->normal_W).dot(home_W_m.normalized());
    if (miss_1 < std::cos(options_.half_cone_rad)) return;
    Consider(0.5 * (ray.hit->distance_m + second->distance_m + home_W_m.norm()),
             options_.corner_1 * ray.beam_1);
  }

  const Surroundings& surroundings_;
  const geometry::RigidTransform& X_WS_;
  const SonarEchoOptions& options_;
  double loudness_1_;
  std::optional<double> nearest_m_;
};

}  // namespace

std::optional<double> SonarEcho_m(const Surroundings& surroundings,
                                  const geometry::RigidTransform& X_WS,
                                  const SonarEchoOptions& options, double loudness_1) {
  return Ping(surroundings, X_WS, options, loudness_1).NearestEcho_m();
}

}  // namespace geon::sim
