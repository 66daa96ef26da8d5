#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "geometry/rigid_transform.h"

namespace geon::geons {

// Source: none needed; the divergence theorem gives the volume.
//
// A surface of triangles. Corners are counter-clockwise seen from outside; normals (unit, outward)
// belong to vertices, so that a smooth surface shades smoothly.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices_m;
  std::vector<Eigen::Vector3d> normals;
  std::vector<std::array<int, 3>> triangles;
};

Eigen::AlignedBox3d Bounds(const TriangleMesh& mesh);

// Volume enclosed by a closed mesh; negative when the triangles face inward.
double Volume(const TriangleMesh& mesh);

// Whether every edge is shared by exactly two triangles that run along it in opposite directions.
bool IsClosed(const TriangleMesh& mesh);

void Transform(const geometry::RigidTransform& X_AB, TriangleMesh* mesh);

// Moves the mesh so that it stands on z = 0 with the middle of its bounds above the origin.
void StandOnGround(TriangleMesh* mesh);

// Vertex normals as the area-weighted mean of the adjacent faces', with vertices split where faces
// meet at more than `crease_rad`.
TriangleMesh WithFaceNormals(const TriangleMesh& mesh, double crease_rad);

}  // namespace geon::geons
