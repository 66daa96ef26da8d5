#include "sim/view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/hash_noise.h"

namespace geon::sim {
namespace {

using Eigen::Vector3f;

// Shares of the light on a floor right below the lamp.
constexpr float kLampShare_1 = 0.6F;
constexpr float kRoomShare_1 = 0.4F;
// What lies behind the world: the far walls of the room, as bright as the room lights them.
constexpr float kBackdrop_1 = 0.3F;
constexpr float kGrooveHalfWidth_m = 0.004F;
constexpr float kGrooveDarkness_1 = 0.55F;

struct Lights {
  // The lamp is a panel; pixels of a 2 x 2 block ask one of its quarters each.
  std::array<Vector3f, 4> lamp_quarters_W_m;
  Vector3f lamp_W_m = Vector3f::Zero();
  Vector3f lamp_1 = Vector3f::Zero();
  Vector3f room_1 = Vector3f::Zero();
  Vector3f sun_1 = Vector3f::Zero();
  Vector3f to_sun_W = Vector3f::UnitZ();
};

Lights LightsOf(const Lighting& lighting) {
  Lights lights;
  lights.lamp_W_m = lighting.lamp_W_m.cast<float>();
  const float half_x_m = 0.15F, half_y_m = 0.4F;
  for (size_t k = 0; k < 4; ++k) {
    lights.lamp_quarters_W_m[k] = lights.lamp_W_m + Vector3f(k % 2 == 0 ? -half_x_m : half_x_m,
                                                             k / 2 == 0 ? -half_y_m : half_y_m, 0);
  }
  const Vector3f white = BlackBodyColor(lighting.kelvin) * static_cast<float>(lighting.level_1);
  lights.lamp_1 = white * kLampShare_1;
  lights.room_1 = white * kRoomShare_1;
  constexpr double kSun_K = 5500.0;
  lights.sun_1 = BlackBodyColor(kSun_K) * static_cast<float>(lighting.sun.level_1);
  const double c = std::cos(lighting.sun.elevation_rad);
  lights.to_sun_W =
      Eigen::Vector3d(c * std::cos(lighting.sun.azimuth_rad),
                      c * std::sin(lighting.sun.azimuth_rad), std::sin(lighting.sun.elevation_rad))
          .cast<float>();
  return lights;
}

// How much of a footprint of `size_m` is covered by the grooves nearest to x: drawn lines that fade
// with distance instead of breaking up.
float GrooveCover(float x_m, float tile_m, float size_m) {
  const float distance_m = std::abs(x_m - tile_m * std::round(x_m / tile_m));
  const float inside_1 = (kGrooveHalfWidth_m + 0.5F * size_m - distance_m) / size_m;
  return std::clamp(inside_1, 0.0F, std::min(1.0F, 2.0F * kGrooveHalfWidth_m / size_m));
}

// Tiles differ a little from each other, are mottled, and have dark grooves between them.
float TilePattern(const Vector3f& p_W, float tile_m, float footprint_m) {
  const auto column = static_cast<int32_t>(std::floor(p_W.x() / tile_m));
  const auto row = static_cast<int32_t>(std::floor(p_W.y() / tile_m));
  float shade_1 = 1.0F + 0.04F * (HashUniform(17, column, row) - 0.5F);
  constexpr float kMottle_m = 0.012F;
  const auto i = static_cast<int32_t>(std::floor(p_W.x() / kMottle_m));
  const auto j = static_cast<int32_t>(std::floor(p_W.y() / kMottle_m));
  shade_1 += 0.06F * (HashUniform(23, i, j) - 0.5F) * std::min(1.0F, kMottle_m / footprint_m);
  const float cover_1 = std::max(GrooveCover(p_W.x(), tile_m, footprint_m),
                                 GrooveCover(p_W.y(), tile_m, footprint_m));
  return shade_1 * (1.0F - kGrooveDarkness_1 * cover_1);
}

// Blinn's highlight with exponent 32; `twice_halfway` need not be a unit vector.
float Highlight(const Vector3f& normal, const Vector3f& twice_halfway) {
  const float along = normal.dot(twice_halfway);
  const float cosine2 = along * along / twice_halfway.squaredNorm();
  if (along <= 0.0F || cosine2 < 0.7F) return 0.0F;  // below 1/300 of its crest
  const float cosine8 = cosine2 * cosine2 * cosine2 * cosine2;
  const float cosine16 = cosine8 * cosine8;
  return cosine16 * cosine16;
}

// 1 where the lamp shines freely. Each pixel asks one quarter of the lamp, then takes the mean of
// its block, so that shadows have a soft edge.
std::vector<float> LampVisibility(const Scene& scene, const View& view, const Lights& lights) {
  const int width = view.camera.width_px, height = view.camera.height_px;
  std::vector<uint8_t> lit(view.sightings.size(), 1);
  for (int quarter = 0; quarter < 4; ++quarter) {
    std::vector<Vector3f> points;
    std::vector<size_t> owners;
    points.reserve(lit.size() / 4);
    owners.reserve(lit.size() / 4);
    for (int v = quarter / 2; v < height; v += 2) {
      for (int u = quarter % 2; u < width; u += 2) {
        const size_t pixel =
            static_cast<size_t>(v) * static_cast<size_t>(width) + static_cast<size_t>(u);
        const Sighting& sighting = view.sightings[pixel];
        const Vector3f to_lamp = lights.lamp_W_m - sighting.p_W_m;
        if (sighting.body < 0) continue;
        if (sighting.normal_W.dot(to_lamp) <= 0.0F) continue;  // turned away: no light to shade
        owners.push_back(pixel);
        points.push_back(sighting.p_W_m);
      }
    }
    std::vector<uint8_t> answers(points.size());
    scene.Illuminate(lights.lamp_quarters_W_m[static_cast<size_t>(quarter)], points, answers);
    for (size_t k = 0; k < owners.size(); ++k) lit[owners[k]] = answers[k];
  }
  std::vector<float> visibility(lit.size());
  for (int v = 0; v < height; ++v) {
    const int v2 = v + 1 < height ? v + 1 : v - 1;
    for (int u = 0; u < width; ++u) {
      const int u2 = u + 1 < width ? u + 1 : u - 1;
      const auto at = [&](int row, int column) {
        return static_cast<int>(lit[static_cast<size_t>(row) * static_cast<size_t>(width) +
                                    static_cast<size_t>(column)]);
      };
      visibility[static_cast<size_t>(v) * static_cast<size_t>(width) + static_cast<size_t>(u)] =
          0.25F * static_cast<float>(at(v, u) + at(v, u2) + at(v2, u) + at(v2, u2));
    }
  }
  return visibility;
}

// 1 where the sun shines. Its rays are parallel: they come from a point far away.
std::vector<uint8_t> SunVisibility(const Scene& scene, const View& view, const Lights& lights) {
  std::vector<uint8_t> lit(view.sightings.size(), 0);
  if (lights.sun_1.maxCoeff() <= 0.0F) return lit;
  std::vector<Vector3f> points;
  for (const Sighting& sighting : view.sightings) points.push_back(sighting.p_W_m);
  constexpr float kSunDistance_m = 200.0F;
  scene.Illuminate(lights.lamp_W_m + kSunDistance_m * lights.to_sun_W, points, lit);
  return lit;
}

}  // namespace

void LookThrough(const Scene& scene, const geometry::PinholeCamera& camera,
                 const geometry::RigidTransform& X_WC, View* view) {
  view->camera = camera;
  view->X_WC = X_WC;
  const auto width = static_cast<size_t>(camera.width_px),
             height = static_cast<size_t>(camera.height_px);
  view->sightings.resize(width * height);
  const Eigen::Matrix3f R_WC = X_WC.linear().cast<float>();
  const Vector3f origin_W_m = X_WC.translation().cast<float>();
  std::vector<Vector3f> directions(width);
  for (size_t v = 0; v < height; ++v) {
    for (size_t u = 0; u < width; ++u) {
      directions[u] =
          R_WC * camera.Ray(static_cast<double>(u), static_cast<double>(v)).cast<float>();
    }
    scene.Look(origin_W_m, directions, std::span(view->sightings).subspan(v * width, width));
  }
}

std::vector<float> ShadeColor(const Scene& scene, const View& view, LampShadows shadows) {
  const Lights lights = LightsOf(scene.lighting());
  const std::vector<float> lamp_visible = shadows == LampShadows::kSoft
                                              ? LampVisibility(scene, view, lights)
                                              : std::vector<float>(view.sightings.size(), 1.0F);
  const std::vector<uint8_t> sun_visible = SunVisibility(scene, view, lights);
  const Vector3f eye = view.X_WC.translation().cast<float>();
  const float lamp_height2_m2 = lights.lamp_W_m.z() * lights.lamp_W_m.z();
  const auto pixel_rad = static_cast<float>(1.0 / view.camera.fx_px);
  std::vector<float> light(3 * view.sightings.size(), 0.0F);
  for (size_t k = 0; k < view.sightings.size(); ++k) {
    const Sighting& s = view.sightings[k];
    if (s.body < 0) {
      for (int c = 0; c < 3; ++c)
        light[3 * k + static_cast<size_t>(c)] = kBackdrop_1 * lights.room_1[c];
      continue;
    }
    const Material& material = scene.bodies()[static_cast<size_t>(s.body)].material;
    const Vector3f to_eye = eye - s.p_W_m;
    const float eye_distance_m = to_eye.norm();
    const Vector3f view_direction = to_eye / eye_distance_m;
    const Vector3f to_lamp = lights.lamp_W_m - s.p_W_m;
    const float lamp_distance2_m2 = to_lamp.squaredNorm();
    const Vector3f lamp_direction = to_lamp / std::sqrt(lamp_distance2_m2);
    // A long lamp under a white ceiling: its light falls off with the distance, not with its
    // square.
    const float fall_1 = std::sqrt(lamp_height2_m2 / lamp_distance2_m2);
    const float lamp_1 = lamp_visible[k] * fall_1;
    const float diffuse_1 = lamp_1 * std::max(0.0F, s.normal_W.dot(lamp_direction));
    // Walls and ceiling light what faces up more than what faces down.
    const float room_1 = 0.75F + 0.25F * s.normal_W.z();
    const float sun_1 =
        sun_visible[k] != 0 ? std::max(0.0F, s.normal_W.dot(lights.to_sun_W)) : 0.0F;
    const float gloss_1 =
        material.gloss_1 * lamp_1 * Highlight(s.normal_W, view_direction + lamp_direction);
    float pattern_1 = 1.0F;
    if (material.tile_m > 0.0F) {
      const float slant_1 = std::max(0.05F, std::abs(s.normal_W.dot(view_direction)));
      pattern_1 = TilePattern(s.p_W_m, material.tile_m, pixel_rad * eye_distance_m / slant_1);
    }
    const Vector3f irradiance =
        diffuse_1 * lights.lamp_1 + room_1 * lights.room_1 + sun_1 * lights.sun_1;
    const Vector3f out =
        pattern_1 * material.color_1.cwiseProduct(irradiance) + gloss_1 * lights.lamp_1;
    light[3 * k] = out.x();
    light[3 * k + 1] = out.y();
    light[3 * k + 2] = out.z();
  }
  return light;
}

}  // namespace geon::sim
