#include "geons/geon_shape.h"

#include <string>

#include "base/angles.h"

namespace geon::geons {

int StablePositionCount(GeonLabel label) {
  switch (label) {
    case GeonLabel::kCylinder:
    case GeonLabel::kBentCylinder:
      return 2;
    case GeonLabel::kCuboid:
    case GeonLabel::kEllipsoid:
    case GeonLabel::kTaperedCuboid:
    case GeonLabel::kTaperedCylinder:
    case GeonLabel::kBentCuboid:
      return 3;
  }
  return 0;
}

Status Validate(const GeonShape& shape) {
  const std::string name(ToString(shape.label));
  if (!(shape.size_m.minCoeff() > 0.0))
    return Status::Error("every size of a geon must be positive");
  if (IsTapered(shape.label)) {
    if (!(shape.taper_1 > 0.0 && shape.taper_1 < 1.0)) {
      return Status::Error("taper of a " + name + " must be between 0 and 1");
    }
  } else if (shape.taper_1 != 0.0) {
    return Status::Error("a " + name + " has no taper");
  }
  if (IsBent(shape.label)) {
    if (!(shape.bend_rad > 0.0 && shape.bend_rad <= kPi)) {
      return Status::Error("bend of a " + name + " must be above 0 and at most 180 degrees");
    }
    // The inner side of the arc would pass through the centre of curvature.
    if (!(shape.bend_rad * 0.5 * shape.size_m.x() < shape.size_m.z())) {
      return Status::Error("a " + name + " this thick cannot be bent so far: it would cut itself");
    }
  } else if (shape.bend_rad != 0.0) {
    return Status::Error("a " + name + " has no bend");
  }
  const int count = StablePositionCount(shape.label);
  if (shape.position < 1 || shape.position > count) {
    return Status::Error("position of a " + name + " must be 1 to " + std::to_string(count));
  }
  return Status::Ok();
}

}  // namespace geon::geons
