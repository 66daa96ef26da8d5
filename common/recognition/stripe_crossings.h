#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "recognition/target_stripe.h"

namespace geon::recognition {

// The surface where a horizontal and a vertical stripe cross; frame L, normals unit and towards the
// camera.
struct Crossing {
  Eigen::Vector3d p_L_m;
  Eigen::Vector3d normal_L;       // from the points next to the crossing
  Eigen::Vector3d face_normal_L;  // from the straight pieces (straight_pieces.h) that cross here
};

// By row (horizontal stripe) and column (vertical stripe); nothing where the two do not meet.
using CrossingGrid = std::array<std::array<std::optional<Crossing>, 3>, 3>;

// Source: ours. The thesis reads each stripe by itself; two stripes that cross give the two
// tangents that make a normal.
CrossingGrid FindCrossings(const TargetView& view);

}  // namespace geon::recognition
