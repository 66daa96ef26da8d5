#include "sim/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "sim/floor_tiles.h"
#include "sim/lamp_mirror.h"
#include "sim/light_shadow.h"
#include "sim/pixel_footprint.h"
#include "sim/surface_row.h"

namespace geon::sim {
namespace {

using Eigen::Vector3f;

constexpr float kRoomShare_1 = 0.4F;  // of the light on a floor right below the lamp
// What lies behind the world: the far walls of the room, as bright as the room lights them.
constexpr float kBackdrop_1 = 0.3F;

struct Lights {
  Vector3f lamp_W_m = Vector3f::Zero();
  Vector3f lamp_1 = Vector3f::Zero();
  Vector3f room_1 = Vector3f::Zero();
  Vector3f sun_1 = Vector3f::Zero();
  Vector3f to_sun_W = Vector3f::UnitZ();
};

Lights LightsOf(const Lighting& lighting) {
  Lights lights;
  lights.lamp_W_m = lighting.lamp_W_m.cast<float>();
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

// Blinn's highlight with exponent 32; `along` is the normal's product with the sum of the unit
// vectors to the eye and to the lamp, `length2` the square of that sum.
inline float Highlight(float along, float length2) {
  const float cosine2 = along * along / length2;
  const float cosine4 = cosine2 * cosine2;
  const float cosine8 = cosine4 * cosine4;
  const float cosine16 = cosine8 * cosine8;
  // Below 1/300 of its crest it is not seen.
  const float seen = cosine2 >= 0.7F ? cosine16 * cosine16 : 0.0F;
  return along > 0.0F ? seen : 0.0F;
}

// What one row needs while it is shaded, one value a column.
struct RowOfLight {
  explicit RowOfLight(size_t width)
      : lamp_visible_1(width),
        sun_visible_1(width),
        footprint_m(width),
        diffuse_1(width),
        room_1(width),
        sun_1(width),
        gloss_1(width),
        pattern_1(width) {}
  std::vector<float> lamp_visible_1, sun_visible_1;
  std::vector<float> footprint_m;  // side of the square that a pixel sees
  std::vector<float> diffuse_1, room_1, sun_1, gloss_1, pattern_1;
};

// How strongly each light comes back from the columns of a run.
void ShineOn(const SurfaceRow& row, const SurfaceRow::Run& run, const Lights& lights,
             const Vector3f& eye, float pixel_rad, RowOfLight* light) {
  const float *x_m = row.x_m.data(), *y_m = row.y_m.data(), *z_m = row.z_m.data();
  const float *nx = row.normal_x.data(), *ny = row.normal_y.data(), *nz = row.normal_z.data();
  const float *lamp_visible_1 = light->lamp_visible_1.data(),
              *sun_visible_1 = light->sun_visible_1.data();
  float *diffuse_1 = light->diffuse_1.data(), *room_1 = light->room_1.data(),
        *sun_1 = light->sun_1.data(), *gloss_1 = light->gloss_1.data(),
        *footprint_m = light->footprint_m.data();
  // Plain numbers: the compiler makes vectors of loops over these.
  const float eye_x = eye.x(), eye_y = eye.y(), eye_z = eye.z();
  const float lamp_x = lights.lamp_W_m.x(), lamp_y = lights.lamp_W_m.y(),
              lamp_z = lights.lamp_W_m.z();
  const float sun_x = lights.to_sun_W.x(), sun_y = lights.to_sun_W.y(), sun_z = lights.to_sun_W.z();
#pragma GCC ivdep
  for (int u = run.begin; u < run.end; ++u) {
    const float ex = eye_x - x_m[u], ey = eye_y - y_m[u], ez = eye_z - z_m[u];
    const float eye_distance_m = std::sqrt(ex * ex + ey * ey + ez * ez);
    const float per_eye = 1.0F / eye_distance_m;
    const float lx = lamp_x - x_m[u], ly = lamp_y - y_m[u], lz = lamp_z - z_m[u];
    const float per_lamp = 1.0F / std::sqrt(lx * lx + ly * ly + lz * lz);
    const float to_eye = (nx[u] * ex + ny[u] * ey + nz[u] * ez) * per_eye;
    const float to_lamp = (nx[u] * lx + ny[u] * ly + nz[u] * lz) * per_lamp;
    // A long lamp under a white ceiling: its light falls off with the distance, not with its
    // square.
    const float lamp_1 = lamp_visible_1[u] * lamp_z * per_lamp;
    const float eye_to_lamp = (ex * lx + ey * ly + ez * lz) * (per_eye * per_lamp);
    diffuse_1[u] = lamp_1 * std::max(0.0F, to_lamp);
    gloss_1[u] = lamp_1 * Highlight(to_eye + to_lamp, 2.0F + 2.0F * eye_to_lamp);
    // Walls and ceiling light what faces up more than what faces down.
    room_1[u] = 0.75F + 0.25F * nz[u];
    const float to_sun = nx[u] * sun_x + ny[u] * sun_y + nz[u] * sun_z;
    sun_1[u] = sun_visible_1[u] * std::max(0.0F, to_sun);
    footprint_m[u] = pixel_rad * eye_distance_m / std::max(0.05F, to_eye);
  }
}

// Which colours a picture has, in the order of its values: 0 red, 1 green, 2 blue.
using Colors = std::span<const int>;

void Mix(const SurfaceRow::Run& run, const Material& material, const Lights& lights,
         const RowOfLight& light, Colors colors, float* out) {
  const float *diffuse_1 = light.diffuse_1.data(), *room_1 = light.room_1.data(),
              *sun_1 = light.sun_1.data(), *gloss_1 = light.gloss_1.data(),
              *pattern_1 = light.pattern_1.data();
  const int depth = static_cast<int>(colors.size());
  for (int c = 0; c < depth; ++c) {
    const int color = colors[static_cast<size_t>(c)];
    const float paint_1 = material.color_1[color];
    const float mirrored_1 = material.gloss_1 * lights.lamp_1[color];
    const float lamp_1 = lights.lamp_1[color], walls_1 = lights.room_1[color];
    const float sunlight_1 = lights.sun_1[color];
    for (int u = run.begin; u < run.end; ++u) {
      const float irradiance = diffuse_1[u] * lamp_1 + room_1[u] * walls_1 + sun_1[u] * sunlight_1;
      out[depth * u + c] = pattern_1[u] * paint_1 * irradiance + gloss_1[u] * mirrored_1;
    }
  }
}

void AddMirroredLamp(const SurfaceRow& row, const SurfaceRow::Run& run, float mirror_1,
                     const Lights& lights, const Vector3f& eye,
                     const std::vector<float>& lamp_visible_1, Colors colors, float* out) {
  for (int u = run.begin; u < run.end; ++u) {
    const float share_1 = mirror_1 * lamp_visible_1[static_cast<size_t>(u)] *
                          MirroredLamp_1(row.Point(u), eye, lights.lamp_W_m);
    float* pixel = out + static_cast<int>(colors.size()) * u;
    for (int color : colors) *pixel++ += share_1 * lights.lamp_1[color];
  }
}

void DrawChecks(const View& view, const SurfaceRow& row, const SurfaceRow::Run& run,
                const Checks& checks, std::vector<float>* pattern_1) {
  const Eigen::Matrix3d R_WC = view.X_WC.linear();
  const Vector3f eye = view.X_WC.translation().cast<float>(), ahead = R_WC.col(2).cast<float>();
  const std::array<Vector3f, 2> ray_steps = {(R_WC.col(0) / view.camera.fx_px).cast<float>(),
                                             (R_WC.col(1) / view.camera.fy_px).cast<float>()};
  for (int u = run.begin; u < run.end; ++u) {
    const Vector3f p_W_m = row.Point(u);
    const auto sides = PixelFootprint(p_W_m - eye, row.Normal(u), ahead, ray_steps);
    (*pattern_1)[static_cast<size_t>(u)] = PaintLeft(checks, p_W_m, sides[0], sides[1]);
  }
}

void ShadeRow(const Scene& scene, const View& view, const SurfaceRow& row, const Lights& lights,
              RowOfLight* light, Colors colors, float* out) {
  const Vector3f eye = view.X_WC.translation().cast<float>();
  const auto pixel_rad = static_cast<float>(1.0 / view.camera.fx_px);
  for (const SurfaceRow::Run& run : row.runs) {
    if (run.body < 0) {
      float* pixel = out + static_cast<int>(colors.size()) * run.begin;
      for (int u = run.begin; u < run.end; ++u) {
        for (int color : colors) *pixel++ = kBackdrop_1 * lights.room_1[color];
      }
      continue;
    }
    const Material& material = scene.bodies()[static_cast<size_t>(run.body)].material;
    ShineOn(row, run, lights, eye, pixel_rad, light);
    if (material.tile_m > 0.0F) {
      DrawTiles(row, run, material.tile_m, light->footprint_m, &light->pattern_1);
    } else if (material.checks) {
      DrawChecks(view, row, run, *material.checks, &light->pattern_1);
    } else {
      std::fill(light->pattern_1.begin() + run.begin, light->pattern_1.begin() + run.end, 1.0F);
    }
    Mix(run, material, lights, *light, colors, out);
    if (material.mirror_1 > 0.0F) {
      AddMirroredLamp(row, run, material.mirror_1, lights, eye, light->lamp_visible_1, colors, out);
    }
  }
}

// Mean of each pixel's 2 x 2 block; the last column takes its left neighbour.
void MeanOfBlocks(const std::vector<uint8_t>& lit, const std::vector<uint8_t>& lit_next,
                  std::vector<float>* visible_1) {
  const auto last = static_cast<int>(lit.size()) - 1;
  const uint8_t *here = lit.data(), *below = lit_next.data();
  float* mean_1 = visible_1->data();
  for (int u = 0; u < last; ++u) {
    mean_1[u] = 0.25F * static_cast<float>(here[u] + here[u + 1] + below[u] + below[u + 1]);
  }
  mean_1[last] = mean_1[last - 1];
}

void Shade(const Scene& scene, const View& view, LampShadows shadows, Colors colors,
           std::vector<float>* light) {
  const int width = view.camera.width_px, height = view.camera.height_px;
  light->resize(colors.size() * view.facet.size());
  const Lights lights = LightsOf(scene.lighting());
  LightShadow lamp(scene, lights.lamp_W_m, {kLampPanel_m[0], kLampPanel_m[1]});
  // The sun's rays are parallel: they come from a point far away.
  constexpr float kSunDistance_m = 200.0F;
  const bool sunny = lights.sun_1.maxCoeff() > 0.0F;
  LightShadow sun(scene, lights.lamp_W_m + kSunDistance_m * lights.to_sun_W, {0.0, 0.0});
  std::vector<uint8_t> in_sun(static_cast<size_t>(width));
  RowOfLight row_of_light(static_cast<size_t>(width));
  std::fill(row_of_light.lamp_visible_1.begin(), row_of_light.lamp_visible_1.end(), 1.0F);
  // Rows v and v + 1, alternating: a soft shadow takes both.
  std::array<SurfaceRow, 2> rows;
  std::array<std::vector<uint8_t>, 2> lit;
  const auto resolve = [&](int v) {
    const auto k = static_cast<size_t>(v % 2);
    ResolveRow(scene, view, v, 0, width, &rows[k]);
    if (shadows == LampShadows::kNone) return;
    lit[k].resize(static_cast<size_t>(width));
    lamp.Ask(rows[k], v, lit[k]);
  };
  resolve(0);
  for (int v = 0; v < height; ++v) {
    const auto k = static_cast<size_t>(v % 2);
    if (v + 1 < height) resolve(v + 1);
    if (shadows == LampShadows::kSoft) {
      MeanOfBlocks(lit[k], lit[1 - k], &row_of_light.lamp_visible_1);
    }
    if (sunny) {
      sun.Ask(rows[k], v, in_sun);
      std::copy(in_sun.begin(), in_sun.end(), row_of_light.sun_visible_1.begin());
    }
    ShadeRow(scene, view, rows[k], lights, &row_of_light, colors,
             light->data() + colors.size() * static_cast<size_t>(v) * static_cast<size_t>(width));
  }
}

}  // namespace

void ShadeColor(const Scene& scene, const View& view, LampShadows shadows,
                std::vector<float>* light) {
  constexpr int kBlueGreenRed[] = {2, 1, 0};
  Shade(scene, view, shadows, kBlueGreenRed, light);
}

void ShadeRed(const Scene& scene, const View& view, std::vector<float>* light) {
  constexpr int kRed[] = {0};
  Shade(scene, view, LampShadows::kNone, kRed, light);
}

}  // namespace geon::sim
