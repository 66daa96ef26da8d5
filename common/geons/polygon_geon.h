#pragma once

#include "geons/geon_shape.h"
#include "geons/triangle_mesh.h"

namespace geon::geons {

// A geon of flat faces and sharp edges in its stable position, standing on z = 0 with the middle of
// its bounds above the origin: the same numbers as GeonMesh, made another way.
//
// Source: the volumes that Biederman's geons stand for (thesis section 2.3.1): boxes, prisms,
// frusta, swept arcs. A second generator, so that a recogniser cannot learn the habits of the
// first: nothing is rounded, and no superquadric takes part. A closed polygon of `sides` corners (a
// rectangle for the cuboids) is moved along the axis, grown or turned on its way, and capped; the
// ellipsoid is made of `sides` / 2 such rings. Deviation: a round section is a polygon whose area,
// not radius, is that of the circle.
TriangleMesh PolygonGeon(const GeonShape& shape, int sides);

// A cup, bowl or tub: the same of a cuboid or cylinder, tapered or not, that stands and is open at
// the top, with walls of `wall_1` of its half width. Position 3 of a tapered one is open at its
// larger end, all others at their smaller.
TriangleMesh PolygonVessel(const GeonShape& shape, double wall_1, int sides);

}  // namespace geon::geons
