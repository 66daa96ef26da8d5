#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "geons/triangle_mesh.h"

namespace geon::sim {

// The surfaces of all bodies as one list of triangles in frame W, for those who ask each of them in
// turn. Coordinates are rounded to float as Embree has them, so that both see the same surfaces.
class Facets {
 public:
  struct Facet {
    int body;
    std::array<int, 3> corners;  // numbers in corners_W_m() and normals_W()
  };
  // What belongs to one body: [first, end) of facets and of corners.
  struct Part {
    int first_facet, end_facet;
    int first_corner, end_corner;
    Eigen::AlignedBox3d bounds_W_m;
    bool convex_polyhedron;  // flat faces and nothing in front of any of them: no shadow on itself
  };

  // The next body.
  void Append(const geons::TriangleMesh& surface_W);

  const std::vector<Facet>& facets() const { return facets_; }
  const std::vector<Part>& parts() const { return parts_; }
  const std::vector<Eigen::Vector3d>& corners_W_m() const { return corners_W_m_; }
  const std::vector<Eigen::Vector3d>& normals_W() const { return normals_W_; }

 private:
  bool IsConvexPolyhedron(const Part& part) const;

  std::vector<Facet> facets_;
  std::vector<Part> parts_;
  std::vector<Eigen::Vector3d> corners_W_m_;
  std::vector<Eigen::Vector3d> normals_W_;  // unit, outward
};

}  // namespace geon::sim
