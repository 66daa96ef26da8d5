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
constexpr int kBlock = 64;  // columns at a time: look-ups and arithmetic apart, on the stack

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

// Random numbers in [0, 1) that belong to the squares of a grid, for up to kBlock places.
void FillFromSquares(uint64_t seed, float side_m, const float* x_m, const float* y_m, int count,
                     float* values_1) {
  int32_t columns[kBlock], rows[kBlock];
  const float per_side_1_m = 1.0F / side_m;
  for (int k = 0; k < count; ++k) {
    columns[k] = Floor(x_m[k] * per_side_1_m);
    rows[k] = Floor(y_m[k] * per_side_1_m);
  }
  float value_1 = 0.0F;
  for (int k = 0; k < count; ++k) {
    const bool same = k > 0 && columns[k] == columns[k - 1] && rows[k] == rows[k - 1];
    if (!same) value_1 = HashUniform(seed, columns[k], rows[k]);  // neighbours mostly share one
    values_1[k] = value_1;
  }
}

void DrawBlock(const float* x_m, const float* y_m, const float* footprint_m, float tile_m,
               int count, float* shade_1) {
  float tiles_1[kBlock], mottles_1[kBlock];
  FillFromSquares(17, tile_m, x_m, y_m, count, tiles_1);
  FillFromSquares(23, kMottle_m, x_m, y_m, count, mottles_1);
  const float per_tile_1_m = 1.0F / tile_m;
#pragma GCC ivdep
  for (int k = 0; k < count; ++k) {
    const float per_footprint_1_m = 1.0F / footprint_m[k];
    const float faded_1 = std::min(1.0F, kMottle_m * per_footprint_1_m);
    const float cover_1 = std::max(GrooveCover(x_m[k], tile_m, per_tile_1_m, per_footprint_1_m),
                                   GrooveCover(y_m[k], tile_m, per_tile_1_m, per_footprint_1_m));
    const float paint_1 =
        1.0F + 0.04F * (tiles_1[k] - 0.5F) + 0.06F * (mottles_1[k] - 0.5F) * faded_1;
    shade_1[k] = paint_1 * (1.0F - kGrooveDarkness_1 * cover_1);
  }
}

}  // namespace

void DrawTiles(const SurfaceRow& row, const SurfaceRow::Run& run, float tile_m,
               const std::vector<float>& footprint_m, std::vector<float>* shade_1) {
  for (int begin = run.begin; begin < run.end; begin += kBlock) {
    DrawBlock(&row.x_m[static_cast<size_t>(begin)], &row.y_m[static_cast<size_t>(begin)],
              &footprint_m[static_cast<size_t>(begin)], tile_m, std::min(kBlock, run.end - begin),
              &(*shade_1)[static_cast<size_t>(begin)]);
  }
}

}  // namespace geon::sim
