#include "geons/stable_position.h"

#include <cmath>

#include "base/angles.h"
#include "geometry/rigid_transform.h"

namespace geon::geons {

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

}  // namespace geon::geons
