#include "sim/laser_light.h"

#include <algorithm>
#include <cmath>

#include "sim/gaussian_table.h"
#include "sim/hash_noise.h"

namespace geon::sim {
namespace {

using Eigen::Vector3f;

constexpr float kReach_sigmas = 4.5F;

// How quickly the distance from the fan's plane changes from a pixel to the next, from the plane
// that touches the surface there: variance of the pixel's own width (a box of width w has w^2 /
// 12).
float FootprintVariance(const View& view, const Sighting& s, const Vector3f& normal_of_fan) {
  const Eigen::Matrix3f R_WC = view.X_WC.linear().cast<float>();
  const Vector3f from_eye = s.p_W_m - view.X_WC.translation().cast<float>();
  const float depth_m = from_eye.dot(R_WC.col(2));
  const Vector3f ray = from_eye / depth_m;
  // A surface seen edge-on would spread without bounds.
  const float facing = std::min(-0.05F, s.normal_W.dot(ray));
  float variance_m2 = 0.0F;
  const float steps[2] = {static_cast<float>(1.0 / view.camera.fx_px),
                          static_cast<float>(1.0 / view.camera.fy_px)};
  for (int axis = 0; axis < 2; ++axis) {
    const Vector3f ray_step = R_WC.col(axis) * steps[axis];
    const Vector3f p_step = depth_m * (ray_step - ray * (s.normal_W.dot(ray_step) / facing));
    const float across_m = normal_of_fan.dot(p_step);
    variance_m2 += across_m * across_m / 12.0F;
  }
  return variance_m2;
}

// Speckle at a pixel: mean 0, standard deviation 1, correlated between neighbours along the stripe.
float Speckle(uint64_t seed, int u, int v, bool along_u) {
  const auto white = [&](int step) {
    const int a = along_u ? u + step : u;
    const int b = along_u ? v : v + step;
    return GaussianTable::At(static_cast<uint16_t>(
        HashMix(seed, static_cast<uint64_t>(a + 1) << 32U | static_cast<uint64_t>(b + 1))));
  };
  constexpr float kNorm = 0.8164966F;  // 1 / sqrt(0.25 + 1 + 0.25)
  return kNorm * (0.5F * white(-1) + white(0) + 0.5F * white(1));
}

struct LitPixel {
  size_t pixel;
  float level;  // before speckle and shadow
};

// Pixels whose surface the fan would reach if nothing stood between.
std::vector<LitPixel> PixelsInFan(const Scene& scene, const View& view, const LaserFan& fan,
                                  const LaserOptions& options) {
  const Vector3f origin = fan.origin_W_m.cast<float>();
  const Vector3f normal = fan.normal_W.cast<float>();
  const Vector3f forward = fan.forward_W.cast<float>();
  const float offset_m = normal.dot(origin);
  const auto waist_m = static_cast<float>(options.waist_sigma_m);
  const auto inverse_divergence_1_m = static_cast<float>(1.0 / options.divergence_m);
  const auto edge_cosine = static_cast<float>(std::cos(options.fan_half_angle_rad));
  const auto sigma_at = [&](float distance_m) {
    const float x = distance_m * inverse_divergence_1_m;
    return waist_m * std::sqrt(1.0F + x * x);
  };
  const float sigma_at_1m = sigma_at(1.0F);
  constexpr float kWidestStripe_m = 0.25F;  // spares a square root where the fan is far away
  std::vector<LitPixel> lit;
  for (size_t k = 0; k < view.sightings.size(); ++k) {
    const Sighting& s = view.sightings[k];
    const float across_m = normal.dot(s.p_W_m) - offset_m;
    if (std::abs(across_m) > kWidestStripe_m || s.body < 0) continue;
    const Vector3f from_laser = s.p_W_m - origin;
    const float distance_m = from_laser.norm();
    const float sigma_m = sigma_at(distance_m);
    if (std::abs(across_m) > kReach_sigmas * sigma_m + 0.02F) continue;
    const float cosine = -s.normal_W.dot(from_laser) / distance_m;
    if (cosine <= 0.0F || forward.dot(from_laser) < edge_cosine * distance_m) continue;
    const float variance_m2 = sigma_m * sigma_m + FootprintVariance(view, s, normal);
    if (across_m * across_m > kReach_sigmas * kReach_sigmas * variance_m2) continue;
    const float profile =
        std::exp(-0.5F * across_m * across_m / variance_m2) * sigma_m / std::sqrt(variance_m2);
    const float reflectance =
        scene.bodies()[static_cast<size_t>(s.body)].material.laser_reflectance_1;
    lit.push_back({k, static_cast<float>(options.crest_1) * reflectance * cosine * profile *
                          (sigma_at_1m / sigma_m) / distance_m});
  }
  return lit;
}

}  // namespace

std::vector<float> LaserLight(const Scene& scene, const View& view, const LaserFan& fan,
                              const LaserOptions& options, uint64_t speckle_seed) {
  const std::vector<LitPixel> in_fan = PixelsInFan(scene, view, fan, options);
  std::vector<Vector3f> points;
  points.reserve(in_fan.size());
  for (const LitPixel& lit : in_fan) points.push_back(view.sightings[lit.pixel].p_W_m);
  std::vector<uint8_t> reached(points.size());
  scene.Illuminate(fan.origin_W_m.cast<float>(), points, reached);

  std::vector<float> light(view.sightings.size(), 0.0F);
  const auto contrast = static_cast<float>(options.speckle_1);
  for (size_t k = 0; k < in_fan.size(); ++k) {
    if (reached[k] == 0) continue;
    const size_t pixel = in_fan[k].pixel;
    const int u = static_cast<int>(pixel % static_cast<size_t>(view.camera.width_px));
    const int v = static_cast<int>(pixel / static_cast<size_t>(view.camera.width_px));
    const float speckle = contrast * Speckle(speckle_seed, u, v, fan.stripe_runs_along_u);
    light[pixel] = in_fan[k].level * std::max(0.0F, 1.0F + speckle);
  }
  return light;
}

}  // namespace geon::sim
