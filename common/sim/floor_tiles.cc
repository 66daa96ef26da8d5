#include "sim/floor_tiles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim/hash_noise.h"

namespace geon::sim {
namespace {

constexpr float kGrooveHalfWidth_m = 0.004F;
constexpr float kGrooveDarkness_1 = 0.55F;
constexpr float kMottle_m = 0.012F;
constexpr float kPerMottle_1_m = 1.0F / kMottle_m;

// As std::floor, which costs a call: for numbers far within the range of an int.
inline int32_t Floor(float x) {
  const auto k = static_cast<int32_t>(x);
  return k - (x < static_cast<float>(k) ? 1 : 0);
}

// How much of a pixel, which sees 1 / `per_footprint` of the floor, is covered by the groove
// nearest to x.
inline float GrooveCover(float x_m, float tile_m, float per_tile_1_m, float per_footprint_1_m) {
  const float distance_m =
      std::abs(x_m - tile_m * static_cast<float>(Floor(x_m * per_tile_1_m + 0.5F)));
  const float inside_1 = (kGrooveHalfWidth_m - distance_m) * per_footprint_1_m + 0.5F;
  const float most_1 = std::min(1.0F, 2.0F * kGrooveHalfWidth_m * per_footprint_1_m);
  return std::max(0.0F, std::min(inside_1, most_1));
}

}  // namespace

void DrawTiles(const SurfaceRow& row, const SurfaceRow::Run& run, float tile_m,
               const std::vector<float>& footprint_m, std::vector<float>* shade_1) {
  const float *x_m = row.x_m.data(), *y_m = row.y_m.data(), *footprint = footprint_m.data();
  float* shade = shade_1->data();
  int32_t column = 0, line = 0;  // the tile of the last column
  float plain_1 = 1.0F;          // and its shade
  const float per_tile_1_m = 1.0F / tile_m;
  for (int u = run.begin; u < run.end; ++u) {
    // Neighbours are on one tile, but seldom in one square of the mottle.
    const int32_t tile_x = Floor(x_m[u] * per_tile_1_m), tile_y = Floor(y_m[u] * per_tile_1_m);
    if (u == run.begin || tile_x != column || tile_y != line) {
      column = tile_x;
      line = tile_y;
      plain_1 = 1.0F + 0.04F * (HashUniform(17, column, line) - 0.5F);
    }
    const int32_t i = Floor(x_m[u] * kPerMottle_1_m), j = Floor(y_m[u] * kPerMottle_1_m);
    shade[u] =
        plain_1 + 0.06F * (HashUniform(23, i, j) - 0.5F) * std::min(1.0F, kMottle_m / footprint[u]);
  }
#pragma GCC ivdep
  for (int u = run.begin; u < run.end; ++u) {
    const float per_footprint_1_m = 1.0F / footprint[u];
    const float cover_1 = std::max(GrooveCover(x_m[u], tile_m, per_tile_1_m, per_footprint_1_m),
                                   GrooveCover(y_m[u], tile_m, per_tile_1_m, per_footprint_1_m));
    shade[u] *= 1.0F - kGrooveDarkness_1 * cover_1;
  }
}

}  // namespace geon::sim
