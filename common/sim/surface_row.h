#pragma once

#include <vector>

#include "sim/scene.h"
#include "sim/view.h"

namespace geon::sim {

// The surfaces that part of a row of pixels looks at, one array for each coordinate so that loops
// over them are fast. Frame W; arrays are indexed by the column u.
struct SurfaceRow {
  // Neighbours on one body; `flat` ones are on one facet of a convex polyhedron, in a straight
  // line.
  struct Run {
    int begin, end;
    int body;  // -1: the rays leave the world, and the arrays say nothing
    bool flat;
  };
  std::vector<Run> runs;
  std::vector<float> x_m, y_m, z_m;
  // Unit, of the smooth surface, towards the viewer.
  std::vector<float> normal_x, normal_y, normal_z;

  Eigen::Vector3f Point(int u) const {
    const auto k = static_cast<size_t>(u);
    return {x_m[k], y_m[k], z_m[k]};
  }
  Eigen::Vector3f Normal(int u) const {
    const auto k = static_cast<size_t>(u);
    return {normal_x[k], normal_y[k], normal_z[k]};
  }
};

// Columns [begin, end) of row v. Fills `row`, whose memory is used again.
void ResolveRow(const Scene& scene, const View& view, int v, int begin, int end, SurfaceRow* row);

// One pixel of it.
Sighting SightingAt(const Scene& scene, const View& view, int u, int v);

}  // namespace geon::sim
