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

// A facet as its pixels see it. A corner's share of the inverse depth at a pixel is the product of
// its row with (u, v, 1); the three sum up to the inverse depth.
struct FacetInView {
  Eigen::Matrix3d shares;
  std::array<Vector3d, 3> normals;
};

FacetInView InView(const Scene& scene, const View& view, const Facets::Facet& facet) {
  const auto corner = [&](size_t k) -> const Vector3d& {
    return view.corners_px_m[static_cast<size_t>(facet.corners[k])];
  };
  const Vector3d &a = corner(0), &b = corner(1), &c = corner(2);
  const Vector3d bc = b.cross(c);
  FacetInView seen;
  const double scale = 1.0 / a.dot(bc);
  seen.shares.row(0) = scale * bc;
  seen.shares.row(1) = scale * c.cross(a);
  seen.shares.row(2) = scale * a.cross(b);
  for (size_t k = 0; k < 3; ++k) {
    seen.normals[k] = scene.facets().normals_W()[static_cast<size_t>(facet.corners[k])];
  }
  return seen;
}

Vector3f TowardsViewer(const Vector3d& normal, const Vector3f& ray) {
  const Vector3f unit = normal.normalized().cast<float>();
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
  const auto fill = [&](std::vector<float>* values, float value) {
    std::fill(values->begin() + begin, values->begin() + end, value);
  };
  fill(&row->normal_x, normal.x());
  fill(&row->normal_y, normal.y());
  fill(&row->normal_z, normal.z());
}

// Columns [begin, end) that see one facet.
void FillFacet(const FacetInView& seen, const RowOfRays& rays, int v, int begin, int end,
               SurfaceRow* row) {
  const Vector3d plane = seen.shares.colwise().sum();
  FillPoints(rays, static_cast<float>(plane.dot(Vector3d(begin, v, 1.0))),
             static_cast<float>(plane.x()), begin, end, row);
  const auto& n = seen.normals;
  const double bent = (n[1] - n[0]).squaredNorm() + (n[2] - n[0]).squaredNorm();
  if (bent < 1e-12) {
    const Vector3f ray = rays.first + static_cast<float>(begin) * rays.step;
    FillNormals(TowardsViewer(n[0], ray), begin, end, row);
    return;
  }
  for (int u = begin; u < end; ++u) {
    const Vector3d share = seen.shares * Vector3d(u, v, 1.0);
    const Vector3f ray = rays.first + static_cast<float>(u) * rays.step;
    FillNormals(TowardsViewer(share[0] * n[0] + share[1] * n[1] + share[2] * n[2], ray), u, u + 1,
                row);
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
