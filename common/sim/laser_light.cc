#include "sim/laser_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/gaussian_table.h"
#include "sim/hash_noise.h"
#include "sim/pixel_footprint.h"

namespace geon::sim {
namespace {

using Eigen::Vector3f;

constexpr float kReach_sigmas = 4.5F;
constexpr float kPixelMargin_m = 0.02F;  // for what the pixels' own width adds

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

// The fan's shape and strength.
struct Beam {
  Beam(const LaserFan& fan, const LaserOptions& options)
      : origin(fan.origin_W_m.cast<float>()),
        normal(fan.normal_W.cast<float>()),
        forward(fan.forward_W.cast<float>()),
        side(normal.cross(forward)),
        edge_tangent(static_cast<float>(std::tan(options.fan_half_angle_rad))),
        bow_1(static_cast<float>(fan.bow_1)),
        waist_m(static_cast<float>(options.waist_sigma_m)),
        inverse_divergence_1_m(static_cast<float>(1.0 / options.divergence_m)),
        crest_1(static_cast<float>(options.crest_1)) {}
  float SigmaAt(float distance_m) const {
    const float x = distance_m * inverse_divergence_1_m;
    return waist_m * std::sqrt(1.0F + x * x);
  }
  // How far the line is off the plane, as a share of the distance forward.
  float BowAt(float tangent) const {
    const float way_1 = tangent / edge_tangent;
    return bow_1 * way_1 * way_1;
  }
  Vector3f origin, normal, forward, side;
  float edge_tangent, bow_1, waist_m, inverse_divergence_1_m, crest_1;
};

// The camera's rays; a lens changes how far a ray is from the next by too little to count.
struct Rays {
  Rays(const BuiltCamera& built, const geometry::RigidTransform& X_WC)
      : camera(built),
        X_CW(X_WC.inverse()),
        R_WC(X_WC.linear()),
        eye(X_WC.translation().cast<float>()),
        ahead(R_WC.col(2).cast<float>()),
        steps{(R_WC.col(0) / built.ideal.fx_px).cast<float>(),
              (R_WC.col(1) / built.ideal.fy_px).cast<float>()} {}
  Vector3f At(int u, int v) const {
    return (R_WC * camera.Ray(Eigen::Vector2d(u, v))).cast<float>();
  }
  std::array<Vector3f, 2> FootprintAt(const Sighting& s) const {
    return PixelFootprint(s.p_W_m - eye, s.normal_W, ahead, steps);
  }
  const BuiltCamera& camera;
  geometry::RigidTransform X_CW;
  Eigen::Matrix3d R_WC;
  Vector3f eye, ahead;
  std::array<Vector3f, 2> steps;  // from a pixel to the next along u and v, at depth 1
};

// Light of the beam at a surface, nothing shadowing it; 0 where it is too faint to care.
float LevelAt(const Scene& scene, const Rays& rays, const Beam& beam, const Sighting& s) {
  const Vector3f from_laser = s.p_W_m - beam.origin;
  const float ahead_m = beam.forward.dot(from_laser);
  const float tangent = beam.side.dot(from_laser) / ahead_m;
  if (ahead_m <= 0.0F || std::abs(tangent) > beam.edge_tangent) return 0.0F;
  const float across_m = beam.normal.dot(from_laser) - beam.BowAt(tangent) * ahead_m;
  const float distance_m = from_laser.norm();
  const float sigma_m = beam.SigmaAt(distance_m);
  if (std::abs(across_m) > kReach_sigmas * sigma_m + kPixelMargin_m) return 0.0F;
  const float cosine = -s.normal_W.dot(from_laser) / distance_m;
  if (cosine <= 0.0F) return 0.0F;
  const std::array<Vector3f, 2> steps_m = rays.FootprintAt(s);
  // How quickly the distance from the fan's plane changes from a pixel to the next: variance of the
  // pixel's own width (a box of width w has w^2 / 12).
  float variance_m2 = sigma_m * sigma_m;
  for (const Vector3f& step_m : steps_m) {
    const float step_across_m = beam.normal.dot(step_m);
    variance_m2 += step_across_m * step_across_m / 12.0F;
  }
  if (across_m * across_m > kReach_sigmas * kReach_sigmas * variance_m2) return 0.0F;
  const float profile =
      std::exp(-0.5F * across_m * across_m / variance_m2) * sigma_m / std::sqrt(variance_m2);
  const Material& material = scene.bodies()[static_cast<size_t>(s.body)].material;
  const float paint_1 =
      material.checks ? PaintLeft(*material.checks, s.p_W_m, steps_m[0], steps_m[1]) : 1.0F;
  return beam.crest_1 * material.laser_reflectance_1 * paint_1 * cosine * profile *
         (beam.SigmaAt(1.0F) / sigma_m) / distance_m;
}

// What a camera may see, and a bit more: inside the four planes through its eye and the picture's
// sides.
class Field {
 public:
  explicit Field(const Rays& rays) : eye_(rays.eye) {
    constexpr int kMargin_px = 20;
    const int right = rays.camera.ideal.width_px + kMargin_px,
              bottom = rays.camera.ideal.height_px + kMargin_px;
    const std::array<Vector3f, 4> corners = {rays.At(-kMargin_px, -kMargin_px),
                                             rays.At(right, -kMargin_px), rays.At(right, bottom),
                                             rays.At(-kMargin_px, bottom)};
    for (size_t k = 0; k < 4; ++k) inward_[k] = corners[k].cross(corners[(k + 1) % 4]);
  }
  // Whether light comes through it.
  bool Meets(const Vector3f& origin, const Vector3f& direction) const {
    float from = 0.0F, to = std::numeric_limits<float>::infinity();
    for (const Vector3f& inward : inward_) {
      const float inside = inward.dot(origin - eye_), gain = inward.dot(direction);
      if (gain > 0.0F) from = std::max(from, -inside / gain);
      if (gain < 0.0F) to = std::min(to, -inside / gain);
      if (gain == 0.0F && inside < 0.0F) return false;
    }
    return from <= to;
  }

 private:
  Vector3f eye_;
  std::array<Vector3f, 4> inward_;  // normals of the sides
};

// Which pixels the fan may light. Three sheets of rays, side by side in the light's thickness, are
// finer than the picture's pixels along the stripe; round what each ray meets, so many pixels
// across the stripe are marked that they reach half way to the next sheet.
class Marks {
 public:
  Marks(const Scene& scene, const Rays& rays, const Beam& beam, bool along_u)
      : scene_(scene),
        rays_(rays),
        beam_(beam),
        along_u_(along_u),
        width_(rays.camera.ideal.width_px),
        height_(rays.camera.ideal.height_px),
        marked_(static_cast<size_t>(width_) * static_cast<size_t>(height_), 0) {
    constexpr float kSheetSpacing_sigmas = 3.0F;  // and half of it beyond: kReach_sigmas
    for (int sheet = -1; sheet <= 1; ++sheet) {
      MarkSheet(static_cast<float>(sheet) * kSheetSpacing_sigmas, kSheetSpacing_sigmas);
    }
  }
  template <typename Use>
  void ForEach(Use use) const {
    const auto width = static_cast<size_t>(width_);
    for (size_t k = 0; k < marked_.size(); ++k) {
      if (marked_[k] != 0) use(static_cast<int>(k % width), static_cast<int>(k / width));
    }
  }

 private:
  void MarkSheet(float offset_sigmas, float spacing_sigmas) {
    const float step_1 = 0.7F / static_cast<float>(rays_.camera.ideal.fx_px);
    // Where thickness grows as waist (1 + distance / divergence), an upper bound.
    const float growth_1 = beam_.waist_m * beam_.inverse_divergence_1_m;
    const Vector3f origin = beam_.origin + offset_sigmas * beam_.waist_m * beam_.normal;
    const Field field(rays_);
    std::vector<Vector3f> directions;
    for (float tangent = -beam_.edge_tangent; tangent <= beam_.edge_tangent; tangent += step_1) {
      const Vector3f direction = beam_.forward + tangent * beam_.side +
                                 (beam_.BowAt(tangent) + offset_sigmas * growth_1) * beam_.normal;
      if (field.Meets(origin, direction)) directions.push_back(direction);
    }
    std::vector<Sighting> sightings(directions.size());
    scene_.Look(origin, directions, sightings);
    for (const Sighting& s : sightings) {
      if (s.body < 0) continue;
      const float distance_m = (s.p_W_m - beam_.origin).norm();
      Mark(s, 0.5F * spacing_sigmas * (beam_.waist_m + growth_1 * distance_m));
    }
  }
  void Mark(const Sighting& s, float reach_m) {
    constexpr float kMost_px = 40.0F;
    constexpr int kBeside_px = 1;
    constexpr double kTooNear_m = 0.01;
    const Eigen::Vector3d p_C_m = rays_.X_CW * s.p_W_m.cast<double>();
    if (p_C_m.z() < kTooNear_m) return;
    const Eigen::Vector2d pixel_px = rays_.camera.Project(p_C_m);
    if (!(pixel_px.cwiseAbs().maxCoeff() < 1e5)) return;
    const float step_across_m = std::abs(beam_.normal.dot(rays_.FootprintAt(s)[along_u_ ? 1 : 0]));
    const int across_px = static_cast<int>(std::min(kMost_px, reach_m / step_across_m + 2.0F));
    const int across_u = along_u_ ? kBeside_px : across_px,
              across_v = along_u_ ? across_px : kBeside_px;
    const int u = static_cast<int>(std::lround(pixel_px.x())),
              v = static_cast<int>(std::lround(pixel_px.y()));
    const int first_u = std::max(0, u - across_u), end_u = std::min(width_, u + across_u + 1);
    for (int row = std::max(0, v - across_v); row < std::min(height_, v + across_v + 1); ++row) {
      if (first_u >= end_u) return;
      uint8_t* marks = marked_.data() + static_cast<size_t>(row) * static_cast<size_t>(width_);
      std::fill(marks + first_u, marks + end_u, uint8_t{1});
    }
  }

  const Scene& scene_;
  const Rays& rays_;
  const Beam& beam_;
  bool along_u_;
  int width_, height_;
  std::vector<uint8_t> marked_;
};

// Pixels whose surface the fan would reach if nothing stood between, and where that is.
void LookInFan(const Scene& scene, const Rays& rays, const Beam& beam, const Marks& marks,
               std::vector<LitPixel>* lit, std::vector<Vector3f>* points_W_m) {
  std::vector<Vector3f> directions;
  marks.ForEach([&](int u, int v) {
    lit->push_back({u, v, 0.0F});
    directions.push_back(rays.At(u, v));
  });
  std::vector<Sighting> sightings(directions.size());
  scene.Look(rays.eye, directions, sightings);
  size_t kept = 0;
  for (size_t k = 0; k < sightings.size(); ++k) {
    if (sightings[k].body < 0) continue;
    const float level = LevelAt(scene, rays, beam, sightings[k]);
    if (level <= 0.0F) continue;
    (*lit)[kept++] = {(*lit)[k].u_px, (*lit)[k].v_px, level};
    points_W_m->push_back(sightings[k].p_W_m);
  }
  lit->resize(kept);
}

}  // namespace

std::vector<LitPixel> LaserLight(const Scene& scene, const BuiltCamera& camera,
                                 const geometry::RigidTransform& X_WC, const LaserFan& fan,
                                 const LaserOptions& options, uint64_t speckle_seed) {
  const Beam beam(fan, options);
  const Rays rays(camera, X_WC);
  const Marks marks(scene, rays, beam, fan.stripe_runs_along_u);
  std::vector<LitPixel> in_fan, lit;
  std::vector<Vector3f> points_W_m;
  LookInFan(scene, rays, beam, marks, &in_fan, &points_W_m);
  std::vector<uint8_t> reached(points_W_m.size());
  scene.Illuminate(beam.origin, points_W_m, reached);
  const auto contrast = static_cast<float>(options.speckle_1);
  for (size_t k = 0; k < in_fan.size(); ++k) {
    if (reached[k] == 0) continue;
    const auto& [u, v, level_1] = in_fan[k];
    const float speckle = contrast * Speckle(speckle_seed, u, v, fan.stripe_runs_along_u);
    lit.push_back({u, v, level_1 * std::max(0.0F, 1.0F + speckle)});
  }
  return lit;
}

}  // namespace geon::sim
