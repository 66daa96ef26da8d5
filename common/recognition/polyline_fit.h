#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "recognition/difference_of_slope.h"

namespace geon::recognition {

struct PolylineOptions {
  double tolerance_m =
      0.003;  // largest distance (Ramer) or area per length (Wall) of a piece's points
  // Reading the pieces, which the thesis leaves open: a turn below `straight_rad` is no turn; two
  // or more successive turns the same way with all pieces between them shorter than `curve_step_1`
  // of the profile form a curve, any other turn above `corner_rad` is a corner.
  double straight_rad = 0.12;
  double corner_rad = 0.50;
  double curve_step_1 = 0.45;
  double concave_rad = 0.25;  // a turn the other way by more than this is a concavity
  void Validate() const;      // throws ContractViolation
};

// Indices of the vertices of a piecewise linear approximation, first and last point included.
// Source: thesis section 5.3; Ramer 1972: split at the point farthest from the chord, until none is
// farther than the tolerance.
std::vector<int> RamerVertices(std::span<const Eigen::Vector2d> curve_m, double tolerance_m);

// Source: thesis section 5.3; Wall and Danielsson 1984: walk along the curve, add up the signed
// area between curve and chord, and start a new piece when the area per length of chord exceeds the
// tolerance.
std::vector<int> WallVertices(std::span<const Eigen::Vector2d> curve_m, double tolerance_m);

// The turn at each inner vertex; positive: convex (clockwise).
std::vector<double> VertexTurns(std::span<const Eigen::Vector2d> curve_m,
                                std::span<const int> vertices);

// Corners, curves and concavities of a piecewise linear curve.
CurveFeatures FindFeatures(std::span<const Eigen::Vector2d> curve_m, std::span<const int> vertices,
                           const PolylineOptions& options);

}  // namespace geon::recognition
