#include "geons/geon_mesh.h"

#include "base/contracts.h"
#include "geons/stable_position.h"

namespace geon::geons {

TriangleMesh GeonMesh(const GeonShape& shape, const MeshResolution& resolution,
                      double edge_exponent_1) {
  const Status valid = Validate(shape);
  Require(valid.ok(), "GeonMesh: " + valid.message());

  Superquadric superquadric;
  superquadric.half_axes_m = 0.5 * shape.size_m;
  superquadric.half_axes_m.head<2>() /= 1.0 + shape.taper_1;  // size_m is the larger end's
  superquadric.profile_exponent_1 = shape.label == GeonLabel::kEllipsoid ? 1.0 : edge_exponent_1;
  superquadric.section_exponent_1 = IsRound(shape.label) ? 1.0 : edge_exponent_1;

  TriangleMesh mesh = SuperquadricMesh(superquadric, resolution);
  if (IsTapered(shape.label)) {
    const double rate_per_m = -shape.taper_1 / superquadric.half_axes_m.z();
    TaperAlongZ({rate_per_m, rate_per_m}, &mesh);
  }
  if (IsBent(shape.label)) BendAlongZ(shape.bend_rad / shape.size_m.z(), &mesh);
  Transform(geometry::MakeTransform(StablePositionRotation(shape), Eigen::Vector3d::Zero()), &mesh);
  StandOnGround(&mesh);
  return mesh;
}

}  // namespace geon::geons
