#pragma once

#include <vector>

#include "sim/surface_row.h"

namespace geon::sim {

// How bright a tiled floor is at the columns of a run, 1 for its paint: tiles differ a little from
// each other, are mottled, and have dark grooves between them. What is smaller than the
// `footprint_m` of a pixel fades instead of breaking up.
void DrawTiles(const SurfaceRow& row, const SurfaceRow::Run& run, float tile_m,
               const std::vector<float>& footprint_m, std::vector<float>* shade_1);

}  // namespace geon::sim
