#pragma once

#include <memory>

#include "base/status.h"
#include "geons/superquadric.h"
#include "sim/scene.h"
#include "sim/world.h"

namespace geon::sim {

// How finely geons' surfaces are made: seen from 1 m away, none of it is off by more than a tenth
// of the head's pixels.
inline constexpr geons::MeshResolution kGeonMesh = {128, 96};

// The world as a scene: floor, walls, and every object in its place; geons' surfaces as fine as
// told. Errors: a mesh file cannot be used.
Result<std::shared_ptr<const Scene>> BuildScene(const World& world,
                                                const geons::MeshResolution& geon_mesh = kGeonMesh);

// A Wavefront OBJ file: polygons are cut into triangles, materials are left out, normals come from
// the faces (creases above 35 degrees stay sharp).
Result<geons::TriangleMesh> LoadObj(const std::filesystem::path& file);

// An object of the world as a mesh in W; of a chessboard, the plate that carries the squares.
Result<geons::TriangleMesh> ObjectMesh(const World& world, const WorldObject& object,
                                       const geons::MeshResolution& geon_mesh = kGeonMesh);

}  // namespace geon::sim
