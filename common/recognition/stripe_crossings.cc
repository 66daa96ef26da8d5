#include "recognition/stripe_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "recognition/straight_pieces.h"

namespace geon::recognition {
namespace {

constexpr size_t kTangentShare = 10;        // a tangent averages this part of a stripe to each side
constexpr double kFarthestCrossing = 0.06;  // in stripe lengths: stripes further apart do not cross

// Index of the point whose coordinate `axis` (nearly monotone along the stripe) is nearest `value`.
size_t Nearest(const std::vector<Eigen::Vector2d>& directions, int axis, double value) {
  const auto above = std::lower_bound(
      directions.begin(), directions.end(), value,
      [axis](const Eigen::Vector2d& direction, double v) { return direction[axis] < v; });
  if (above == directions.begin()) return 0;
  if (above == directions.end()) return directions.size() - 1;
  const auto below = above - 1;
  const bool nearer = value - (*below)[axis] < (*above)[axis] - value;
  return static_cast<size_t>((nearer ? below : above) - directions.begin());
}

// The stripe's direction at a point: from the mean of the points before to that of those after.
Eigen::Vector3d Tangent(const TargetStripe& stripe, size_t at) {
  const size_t reach = std::max<size_t>(stripe.p_L_m.size() / kTangentShare, 2);
  const size_t begin = at > reach ? at - reach : 0;
  const size_t end = std::min(at + reach + 1, stripe.p_L_m.size());
  const size_t middle = std::clamp(at, begin + 1, end - 1);
  Eigen::Vector3d before = Eigen::Vector3d::Zero(), after = before;
  for (size_t i = begin; i < middle; ++i) before += stripe.p_L_m[i];
  for (size_t i = middle; i < end; ++i) after += stripe.p_L_m[i];
  return after / static_cast<double>(end - middle) - before / static_cast<double>(middle - begin);
}

// The direction of the straight piece that holds the point.
Eigen::Vector3d PieceDirection(const std::vector<StraightPiece>& pieces, size_t at) {
  for (const StraightPiece& piece : pieces) {
    if (at < piece.end) return piece.direction_L;
  }
  return pieces.empty() ? Eigen::Vector3d::Zero() : pieces.back().direction_L;
}

// Of the plane of two directions, towards the camera.
Eigen::Vector3d Normal(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                       const Eigen::Vector3d& to_camera) {
  const Eigen::Vector3d normal = a.cross(b).normalized();
  return normal.dot(to_camera) < 0.0 ? -normal : normal;
}

}  // namespace

CrossingGrid FindCrossings(const TargetView& view) {
  const std::vector<TargetStripe>& stripes = view.stripes;
  const Eigen::Vector3d& p_LB_m = view.camera.p_LB_m;

  std::vector<std::vector<StraightPiece>> pieces;
  for (const TargetStripe& stripe : stripes) pieces.push_back(FindStraightPieces(stripe));
  CrossingGrid grid;
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) {
      const TargetStripe& h = stripes[row];
      const TargetStripe& v = stripes[3 + column];
      if (h.p_L_m.size() < 5 || v.p_L_m.size() < 5) continue;
      // From each stripe to the other's level in turn: they are nearly straight and at right
      // angles.
      size_t i = h.p_L_m.size() / 2, j = v.p_L_m.size() / 2;
      for (int pass = 0; pass < 3; ++pass) {
        i = Nearest(h.tangent_B_1, 0, v.tangent_B_1[j].x());
        j = Nearest(v.tangent_B_1, 1, h.tangent_B_1[i].y());
      }
      const double extent = h.tangent_B_1.back().x() - h.tangent_B_1.front().x();
      const double apart = (h.tangent_B_1[i] - v.tangent_B_1[j]).norm();
      if (apart > kFarthestCrossing * std::abs(extent)) continue;
      const Eigen::Vector3d p = 0.5 * (h.p_L_m[i] + v.p_L_m[j]);
      grid[row][column] = Crossing{p, Normal(Tangent(h, i), Tangent(v, j), p_LB_m - p),
                                   Normal(PieceDirection(pieces[row], i),
                                          PieceDirection(pieces[3 + column], j), p_LB_m - p)};
    }
  }
  return grid;
}

}  // namespace geon::recognition
