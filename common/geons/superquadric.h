#pragma once

#include "geons/triangle_mesh.h"

namespace geon::geons {

// The surface |x/a1|^(2/e2) + |y/a2|^(2/e2) raised to e2/e1, plus |z/a3|^(2/e1), equal to 1.
//
// Source: thesis section 2.3 (superquadrics: Pentland [45, 46]); Solina and Bajcsy 1990,
// equation 3. Deviations: vertices are not at equal steps of the angles eta and omega, which leaves
// sharp shapes without vertices on their faces, but at equal steps of arc length and turning angle
// together.
struct Superquadric {
  Eigen::Vector3d half_axes_m = Eigen::Vector3d::Constant(0.1);  // a1, a2, a3
  double profile_exponent_1 = 1.0;                               // e1: 1 round, towards 0 flat caps
  double section_exponent_1 = 1.0;                               // e2: 1 round, towards 0 square
};

struct MeshResolution {
  int around = 256;  // vertices of a cross-section, a multiple of 4
  int along = 192;   // steps from pole to pole, a multiple of 2
};

TriangleMesh SuperquadricMesh(const Superquadric& superquadric, const MeshResolution& resolution);

// Global deformations. Source: Solina and Bajcsy 1990, section II-B (after Barr 1984).
//
// Tapering along z: x and y grow by 1 + rate * z, each at its own rate; `rate_per_m` = (Kx, Ky) /
// a3.
void TaperAlongZ(const Eigen::Vector2d& rate_per_m, TriangleMesh* mesh);

// Circular bending of the z axis towards +x with the given curvature; x must stay below
// 1/curvature.
void BendAlongZ(double curvature_per_m, TriangleMesh* mesh);

}  // namespace geon::geons
