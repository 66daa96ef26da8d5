#pragma once

#include <Eigen/Core>
#include <vector>

#include "recognition/target_stripe.h"

namespace geon::recognition {

// A run of a stripe's points that lie on one line.
struct StraightPiece {
  size_t begin = 0;  // in p_L_m
  size_t end = 0;
  Eigen::Vector3d direction_L = Eigen::Vector3d::UnitX();  // unit, from begin to end
};

// A stripe as one, two or three straight pieces: as few as come within the stripe's noise (or 0.3 %
// of its length) of its points, else three. On a body of flat faces a piece is what one face shows,
// and tells the face's direction far better than a few points round a crossing do. Breaks lie at
// 24ths of the stripe. Empty for a stripe of fewer than 8 points.
//
// Source: Duda and Hart, "Pattern Classification and Scene Analysis", 1973, section 9.2, for lines
// by least squares of perpendicular distances; the search is exhaustive.
std::vector<StraightPiece> FindStraightPieces(const TargetStripe& stripe);

}  // namespace geon::recognition
