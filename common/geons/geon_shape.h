#pragma once

#include <Eigen/Core>

#include "base/geon_label.h"
#include "base/status.h"

namespace geon::geons {

// One of the seven geons in numbers and the stable position it stands in.
//
// Source: thesis section 6.1 (objects made with Wu's `makesq` from 18 superquadric parameters) and
// figures 6.3, 6.5, 6.7, 6.9; Solina and Bajcsy, "Recovery of parametric models from range images",
// 1990.
//
// Before bending and before it is laid down, the geon stands along z and fits a box of size_m.
//   tapered: the larger end, at the bottom, measures size_m x and y; the smaller end is
//            (1 - taper) / (1 + taper) of it.
//   bent:    the axis (z) becomes an arc of bend_rad, centre of curvature on the +x side.
//   position 1, 2, 3: tapered: upright, lying on a flank, inverted; bent: on its side, arch "n",
//   arch "u"
//            (bent cuboid only); cylinder: upright, lying; cuboid, ellipsoid: z, x or y axis
//            upward.
struct GeonShape {
  GeonLabel label = GeonLabel::kCuboid;
  Eigen::Vector3d size_m = Eigen::Vector3d::Constant(0.2);
  double taper_1 = 0.0;   // 0 < taper < 1 for the tapered geons, 0 for the others
  double bend_rad = 0.0;  // 0 < bend <= pi for the bent geons, 0 for the others
  int position = 1;
};

constexpr bool IsTapered(GeonLabel label) {
  return label == GeonLabel::kTaperedCuboid || label == GeonLabel::kTaperedCylinder;
}
constexpr bool IsBent(GeonLabel label) {
  return label == GeonLabel::kBentCuboid || label == GeonLabel::kBentCylinder;
}
// Whether the cross-section is round.
constexpr bool IsRound(GeonLabel label) {
  return label == GeonLabel::kCylinder || label == GeonLabel::kEllipsoid ||
         label == GeonLabel::kTaperedCylinder || label == GeonLabel::kBentCylinder;
}

// How many stable positions tables 6.1-6.7 know for this geon.
int StablePositionCount(GeonLabel label);

// What is wrong with these numbers, if anything.
Status Validate(const GeonShape& shape);

}  // namespace geon::geons
