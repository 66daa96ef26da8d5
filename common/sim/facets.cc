#include "sim/facets.h"

namespace geon::sim {

void Facets::Append(const geons::TriangleMesh& surface_W) {
  Part part;
  part.first_facet = static_cast<int>(facets_.size());
  part.first_corner = static_cast<int>(corners_W_m_.size());
  for (const Eigen::Vector3d& p : surface_W.vertices_m) {
    corners_W_m_.push_back(p.cast<float>().cast<double>());
    part.bounds_W_m.extend(corners_W_m_.back());
  }
  normals_W_.insert(normals_W_.end(), surface_W.normals.begin(), surface_W.normals.end());
  for (const auto& [a, b, c] : surface_W.triangles) {
    facets_.push_back({static_cast<int>(parts_.size()),
                       {part.first_corner + a, part.first_corner + b, part.first_corner + c}});
  }
  part.end_facet = static_cast<int>(facets_.size());
  part.end_corner = static_cast<int>(corners_W_m_.size());
  part.convex_polyhedron = IsConvexPolyhedron(part);
  parts_.push_back(part);
}

bool Facets::IsConvexPolyhedron(const Part& part) const {
  constexpr int kMostFacets = 64;  // boxes, walls, boards; a smooth body would not pass anyway
  constexpr double kTolerance_m = 1e-5;
  if (part.end_facet - part.first_facet > kMostFacets) return false;
  for (int k = part.first_facet; k < part.end_facet; ++k) {
    const auto& corners = facets_[static_cast<size_t>(k)].corners;
    const Eigen::Vector3d& a = corners_W_m_[static_cast<size_t>(corners[0])];
    const Eigen::Vector3d& b = corners_W_m_[static_cast<size_t>(corners[1])];
    const Eigen::Vector3d& c = corners_W_m_[static_cast<size_t>(corners[2])];
    const Eigen::Vector3d outward = (b - a).cross(c - a).normalized();
    for (int corner : corners) {
      if (normals_W_[static_cast<size_t>(corner)].dot(outward) < 1.0 - 1e-6) return false;
    }
    for (int other = part.first_corner; other < part.end_corner; ++other) {
      const double before_m = outward.dot(corners_W_m_[static_cast<size_t>(other)] - a);
      if (before_m > kTolerance_m) return false;
    }
  }
  return true;
}

}  // namespace geon::sim
