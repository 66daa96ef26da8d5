#include "sim/surface_row.h"

namespace geon::sim {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// Rays of a row's pixels in W, of depth 1: first + u * step.
struct RowOfRays {
  Vector3f eye, first, step;
};

RowOfRays RaysOf(const View& view, int v) {
  const Eigen::Matrix3d R_WC = view.X_WC.linear();
  return {view.X_WC.translation().cast<float>(),
          (R_WC * view.camera.Ray(0.0, static_cast<double>(v))).cast<float>(),
          (R_WC.col(0) / view.camera.fx_px).cast<float>()};
}

// A facet as its pixels see it: (u, v, 1) times row k, divided by the volume, is corner k's share
// of the inverse depth.
struct FacetInView {
  Vector3d bc, ca, ab;
  double volume;
  std::array<const Vector3d*, 3> normals;
};

FacetInView InView(const Scene& scene, const View& view, const Facets::Facet& facet) {
  const auto [i, j, k] =
      std::array{static_cast<size_t>(facet.corners[0]), static_cast<size_t>(facet.corners[1]),
                 static_cast<size_t>(facet.corners[2])};
  const Vector3d &a = view.corners_px_m[i], &b = view.corners_px_m[j], &c = view.corners_px_m[k];
  const std::vector<Vector3d>& normals = scene.facets().normals_W();
  FacetInView seen = {
      b.cross(c), c.cross(a), a.cross(b), 0.0, {&normals[i], &normals[j], &normals[k]}};
  seen.volume = a.dot(seen.bc);
  return seen;
}

Vector3f TowardsViewer(const Vector3d& normal, const Vector3f& ray) {
  const Vector3f unit = normal.cast<float>().normalized();
  return unit.dot(ray) > 0.0F ? Vector3f(-unit) : unit;
}

// Points at the given inverse depth, which is linear along the row.
void FillPoints(const RowOfRays& rays, float nearness_1_m, float step_1_m, int begin, int end,
                SurfaceRow* row) {
  float *x_m = row->x_m.data(), *y_m = row->y_m.data(), *z_m = row->z_m.data();
  const Vector3f eye = rays.eye, first = rays.first, step = rays.step;
  for (int u = begin; u < end; ++u) {
    const float column = static_cast<float>(u);
    const float depth_m = 1.0F / (nearness_1_m + static_cast<float>(u - begin) * step_1_m);
    x_m[u] = eye.x() + (first.x() + column * step.x()) * depth_m;
    y_m[u] = eye.y() + (first.y() + column * step.y()) * depth_m;
    z_m[u] = eye.z() + (first.z() + column * step.z()) * depth_m;
  }
}

void FillNormals(const Vector3f& normal, int begin, int end, SurfaceRow* row) {
  for (auto u = static_cast<size_t>(begin); u < static_cast<size_t>(end); ++u) {
    row->normal_x[u] = normal.x();
    row->normal_y[u] = normal.y();
    row->normal_z[u] = normal.z();
  }
}

// Columns [begin, end) that see one facet.
void FillFacet(const FacetInView& seen, const RowOfRays& rays, int v, int begin, int end,
               SurfaceRow* row) {
  const Vector3d plane = (seen.bc + seen.ca + seen.ab) / seen.volume;
  FillPoints(rays, static_cast<float>(plane.x() * begin + plane.y() * v + plane.z()),
             static_cast<float>(plane.x()), begin, end, row);
  const Vector3d &n_a = *seen.normals[0], &n_b = *seen.normals[1], &n_c = *seen.normals[2];
  const double bent = (n_b - n_a).squaredNorm() + (n_c - n_a).squaredNorm();
  if (bent < 1e-12) {
    const Vector3f ray = rays.first + static_cast<float>(begin) * rays.step;
    FillNormals(TowardsViewer(n_a, ray), begin, end, row);
    return;
  }
  const double per_volume = 1.0 / seen.volume;
  for (int u = begin; u < end; ++u) {
    const auto weight = [&](const Vector3d& edge) {
      return (edge.x() * u + edge.y() * v + edge.z()) * per_volume;
    };
    const Vector3f ray = rays.first + static_cast<float>(u) * rays.step;
    const Vector3d normal = weight(seen.bc) * n_a + weight(seen.ca) * n_b + weight(seen.ab) * n_c;
    FillNormals(TowardsViewer(normal, ray), u, u + 1, row);
  }
}

}  // namespace

void ResolveRow(const Scene& scene, const View& view, int v, int begin, int end, SurfaceRow* row) {
  const auto width = static_cast<size_t>(view.camera.width_px);
  for (std::vector<float>* values :
       {&row->x_m, &row->y_m, &row->z_m, &row->normal_x, &row->normal_y, &row->normal_z}) {
    values->resize(width);
  }
  row->runs.clear();
  const int* facet = view.facet.data() + static_cast<size_t>(v) * width;
  const RowOfRays rays = RaysOf(view, v);
  for (int u = begin; u < end;) {
    const int from = u, number = facet[u];
    while (u < end && facet[u] == number) ++u;
    if (number == View::kNothing) {
      row->runs.push_back({from, u, -1, false});
      continue;
    }
    const Facets::Facet& seen = scene.facets().facets()[static_cast<size_t>(number)];
    FillFacet(InView(scene, view, seen), rays, v, from, u, row);
    const bool flat = scene.facets().parts()[static_cast<size_t>(seen.body)].convex_polyhedron;
    const bool continues = !flat && !row->runs.empty() && row->runs.back().body == seen.body;
    if (continues) {
      row->runs.back().end = u;
    } else {
      row->runs.push_back({from, u, seen.body, flat});
    }
  }
}

Sighting SightingAt(const Scene& scene, const View& view, int u, int v) {
  SurfaceRow row;
  ResolveRow(scene, view, v, u, u + 1, &row);
  if (row.runs.front().body < 0) return {};
  return {row.Point(u), row.Normal(u), row.runs.front().body};
}

}  // namespace geon::sim
