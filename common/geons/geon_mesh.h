#pragma once

#include "geons/geon_shape.h"
#include "geons/superquadric.h"
#include "geons/triangle_mesh.h"

namespace geon::geons {

// The surface of a geon in its stable position, standing on z = 0 with the middle of its bounds
// above the origin.
//
// Source: thesis section 6.1 (makesq), figures 6.2-6.10; Solina and Bajcsy 1990 for the
// deformations. Steps: superquadric of the geon's exponents, tapering, bending, rotation into the
// stable position. `edge_exponent_1` rounds the edges: 0.02 leaves about 1 mm on a wooden block of
// 20 cm.
TriangleMesh GeonMesh(const GeonShape& shape, const MeshResolution& resolution = {},
                      double edge_exponent_1 = 0.02);

}  // namespace geon::geons
