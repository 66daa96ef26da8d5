#pragma once

#include <Eigen/Core>

#include "geons/geon_shape.h"

namespace geon::geons {

// The rotation from a geon's own axes to those of the stable position it stands in.
//
// Source: thesis section 6.1, figures 6.3, 6.5, 6.7, 6.9 (GeonShape says which number is which
// position). The flank of a tapered geon that lies is the one on its +x side.
Eigen::Matrix3d StablePositionRotation(const GeonShape& shape);

}  // namespace geon::geons
