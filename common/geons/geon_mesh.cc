#include "geons/geon_mesh.h"

#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::geons {
namespace {

// From the geon's own axes to those of its stable position (figures 6.3, 6.5, 6.7, 6.9).
Eigen::Matrix3d StablePositionRotation(const GeonShape& shape) {
  using geometry::RotationAboutX;
  using geometry::RotationAboutY;
  if (shape.position == 1) {
    return IsBent(shape.label) ? RotationAboutX(kPi / 2) : Eigen::Matrix3d::Identity();
  }
  if (IsTapered(shape.label)) {
    if (shape.position == 3) return RotationAboutX(kPi);
    // The flank on the +x side turns down; it leans inward by the difference of the ends' half
    // widths.
    const double small_end = (1.0 - shape.taper_1) / (1.0 + shape.taper_1);
    const double lean_rad =
        std::atan(0.5 * shape.size_m.x() * (1.0 - small_end) / shape.size_m.z());
    return RotationAboutY(kPi / 2 + lean_rad);
  }
  if (IsBent(shape.label)) return RotationAboutY(shape.position == 2 ? kPi / 2 : -kPi / 2);
  return shape.position == 2 ? RotationAboutY(-kPi / 2) : RotationAboutX(kPi / 2);
}

}  // namespace

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
  if (IsTapered(shape.label)) TaperAlongZ(-shape.taper_1 / superquadric.half_axes_m.z(), &mesh);
  if (IsBent(shape.label)) BendAlongZ(shape.bend_rad / shape.size_m.z(), &mesh);
  Transform(geometry::MakeTransform(StablePositionRotation(shape), Eigen::Vector3d::Zero()), &mesh);
  StandOnGround(&mesh);
  return mesh;
}

}  // namespace geon::geons
