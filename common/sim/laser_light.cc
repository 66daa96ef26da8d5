#include "sim/laser_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/gaussian_table.h"
#include "sim/hash_noise.h"
#include "sim/surface_row.h"

namespace geon::sim {
namespace {

using Eigen::Vector3f;

constexpr float kReach_sigmas = 4.5F;
constexpr float kMargin_m = 0.02F;  // for what the pixels' own width adds

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
  Vector3f p_W_m;
  float level;  // before speckle and shadow
};

// The fan's thickness and strength.
struct Beam {
  Beam(const LaserFan& fan, const LaserOptions& options)
      : origin(fan.origin_W_m.cast<float>()),
        normal(fan.normal_W.cast<float>()),
        forward(fan.forward_W.cast<float>()),
        edge_cosine(static_cast<float>(std::cos(options.fan_half_angle_rad))),
        waist_m(static_cast<float>(options.waist_sigma_m)),
        inverse_divergence_1_m(static_cast<float>(1.0 / options.divergence_m)),
        crest_1(static_cast<float>(options.crest_1)) {}
  float SigmaAt(float distance_m) const {
    const float x = distance_m * inverse_divergence_1_m;
    return waist_m * std::sqrt(1.0F + x * x);
  }
  Vector3f origin, normal, forward;
  float edge_cosine, waist_m, inverse_divergence_1_m, crest_1;
};

// The camera's rays of depth 1.
struct Rays {
  explicit Rays(const View& view)
      : eye(view.X_WC.translation().cast<float>()),
        ahead(view.X_WC.linear().col(2).cast<float>()),
        steps{(view.X_WC.linear().col(0) / view.camera.fx_px).cast<float>(),
              (view.X_WC.linear().col(1) / view.camera.fy_px).cast<float>()},
        corner((view.X_WC.linear() * view.camera.Ray(0.0, 0.0)).cast<float>()) {}
  Vector3f At(int u, int v) const {
    return corner + static_cast<float>(u) * steps[0] + static_cast<float>(v) * steps[1];
  }
  Vector3f eye, ahead;
  std::array<Vector3f, 2> steps;  // from a pixel to the next along u and v
  Vector3f corner;
};

// How quickly the distance from the fan's plane changes from a pixel to the next, from the plane
// that touches the surface there: variance of the pixel's own width (a box of width w has w^2 /
// 12).
float FootprintVariance(const Rays& rays, const Sighting& s, const Vector3f& normal_of_fan) {
  const Vector3f from_eye = s.p_W_m - rays.eye;
  const float depth_m = from_eye.dot(rays.ahead);
  const Vector3f ray = from_eye / depth_m;
  // A surface seen edge-on would spread without bounds.
  const float facing = std::min(-0.05F, s.normal_W.dot(ray));
  float variance_m2 = 0.0F;
  for (const Vector3f& ray_step : rays.steps) {
    const Vector3f p_step = depth_m * (ray_step - ray * (s.normal_W.dot(ray_step) / facing));
    const float across_m = normal_of_fan.dot(p_step);
    variance_m2 += across_m * across_m / 12.0F;
  }
  return variance_m2;
}

// The columns [begin, end) of a row outside of which nothing is within the beam's reach, told from
// depths alone, with distances from the laser taken too long.
struct Columns {
  int begin, end;
};
Columns NearBeam(const View& view, const Rays& rays, const Beam& beam, int v,
                 std::vector<float>* beyond_m) {
  const int width = view.camera.width_px;
  const Vector3f first_ray = rays.At(0, v), last_ray = rays.At(width - 1, v);
  const float eye_m = beam.normal.dot(rays.eye - beam.origin);
  const float first = beam.normal.dot(first_ray), step = beam.normal.dot(rays.steps[0]);
  const float longest_ray = std::max(first_ray.norm(), last_ray.norm());
  // The thickness sigma is at most waist (1 + distance / divergence).
  const float spread_m = kReach_sigmas * beam.waist_m;
  const float farther_m = (rays.eye - beam.origin).norm();
  const float reach_m = kMargin_m + spread_m * (1.0F + farther_m * beam.inverse_divergence_1_m);
  const float reach_step = spread_m * longest_ray * beam.inverse_divergence_1_m;
  const float* nearness_1_m =
      view.nearness_1_m.data() + static_cast<size_t>(v) * static_cast<size_t>(width);
  beyond_m->resize(static_cast<size_t>(width));
  float* beyond = beyond_m->data();
#pragma GCC ivdep
  for (int u = 0; u < width; ++u) {  // where nothing is, far behind everything
    const float depth_m = 1.0F / std::max(1e-6F, nearness_1_m[u]);
    const float across_m = eye_m + (first + static_cast<float>(u) * step) * depth_m;
    beyond[u] = std::abs(across_m) - reach_m - reach_step * depth_m;
  }
  Columns columns{0, width};
  while (columns.begin < columns.end && beyond[columns.begin] > 0.0F) ++columns.begin;
  while (columns.begin < columns.end && beyond[columns.end - 1] > 0.0F) --columns.end;
  return columns;
}

// Light of the beam at a surface, nothing shadowing it; 0 where it is too faint to care.
float LevelAt(const Scene& scene, const Rays& rays, const Beam& beam, const Sighting& s) {
  const Vector3f from_laser = s.p_W_m - beam.origin;
  const float across_m = beam.normal.dot(from_laser);
  const float distance_m = from_laser.norm();
  const float sigma_m = beam.SigmaAt(distance_m);
  if (std::abs(across_m) > kReach_sigmas * sigma_m + kMargin_m) return 0.0F;
  const float cosine = -s.normal_W.dot(from_laser) / distance_m;
  if (cosine <= 0.0F || beam.forward.dot(from_laser) < beam.edge_cosine * distance_m) return 0.0F;
  const float variance_m2 = sigma_m * sigma_m + FootprintVariance(rays, s, beam.normal);
  if (across_m * across_m > kReach_sigmas * kReach_sigmas * variance_m2) return 0.0F;
  const float profile =
      std::exp(-0.5F * across_m * across_m / variance_m2) * sigma_m / std::sqrt(variance_m2);
  const float reflectance =
      scene.bodies()[static_cast<size_t>(s.body)].material.laser_reflectance_1;
  return beam.crest_1 * reflectance * cosine * profile * (beam.SigmaAt(1.0F) / sigma_m) /
         distance_m;
}

// Pixels whose surface the fan would reach if nothing stood between.
std::vector<LitPixel> PixelsInFan(const Scene& scene, const View& view, const Beam& beam) {
  std::vector<LitPixel> lit;
  const Rays rays(view);
  SurfaceRow row;
  std::vector<float> beyond_m;
  for (int v = 0; v < view.camera.height_px; ++v) {
    const Columns columns = NearBeam(view, rays, beam, v, &beyond_m);
    ResolveRow(scene, view, v, columns.begin, columns.end, &row);
    for (const SurfaceRow::Run& run : row.runs) {
      if (run.body < 0) continue;
      for (int u = run.begin; u < run.end; ++u) {
        const Sighting sighting = {row.Point(u), row.Normal(u), run.body};
        const float level = LevelAt(scene, rays, beam, sighting);
        if (level <= 0.0F) continue;
        const auto pixel = static_cast<size_t>(v * view.camera.width_px + u);
        lit.push_back({pixel, sighting.p_W_m, level});
      }
    }
  }
  return lit;
}

}  // namespace

std::vector<float> LaserLight(const Scene& scene, const View& view, const LaserFan& fan,
                              const LaserOptions& options, uint64_t speckle_seed) {
  const std::vector<LitPixel> in_fan = PixelsInFan(scene, view, Beam(fan, options));
  std::vector<Vector3f> points;
  points.reserve(in_fan.size());
  for (const LitPixel& lit : in_fan) points.push_back(lit.p_W_m);
  std::vector<uint8_t> reached(points.size());
  scene.Illuminate(fan.origin_W_m.cast<float>(), points, reached);

  std::vector<float> light(view.facet.size(), 0.0F);
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
