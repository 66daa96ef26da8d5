#include "geometry/convex_polygon.h"

#include "base/contracts.h"

namespace geon::geometry {

namespace {

// A vertex this near to a cutting line lies on it: keeps segments and points, which have no area,
// from being lost to rounding.
constexpr double kOnLine_m = 1e-9;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

ConvexPolygon ConvexPolygon::Box(double half_x_m, double half_y_m) {
  Require(half_x_m > 0.0 && half_y_m > 0.0, "ConvexPolygon::Box: sides must be positive");
  ConvexPolygon box;
  box.vertices_[0] = {-half_x_m, -half_y_m};
  box.vertices_[1] = {half_x_m, -half_y_m};
  box.vertices_[2] = {half_x_m, half_y_m};
  box.vertices_[3] = {-half_x_m, half_y_m};
  box.size_ = 4;
  return box;
}

void ConvexPolygon::Clip(const HalfPlane& half_plane) {
  std::array<Eigen::Vector2d, kMaxVertices> kept;
  int count = 0;
  const auto keep = [&](const Eigen::Vector2d& p_m) {
    Require(count < kMaxVertices, "ConvexPolygon::Clip: more than 64 vertices");
    kept[static_cast<size_t>(count++)] = p_m;
  };
  for (int i = 0; i < size_; ++i) {
    const Eigen::Vector2d& a_m = vertices_[static_cast<size_t>(i)];
    const Eigen::Vector2d& b_m = vertices_[static_cast<size_t>((i + 1) % size_)];
    const double depth_a_m = half_plane.Depth(a_m);
    const double depth_b_m = half_plane.Depth(b_m);
    if (depth_a_m >= -kOnLine_m) keep(a_m);
    if ((depth_a_m > kOnLine_m && depth_b_m < -kOnLine_m) ||
        (depth_a_m < -kOnLine_m && depth_b_m > kOnLine_m)) {
      keep(a_m + (b_m - a_m) * (depth_a_m / (depth_a_m - depth_b_m)));
    }
  }
  for (int i = 0; i < count; ++i) vertices_[static_cast<size_t>(i)] = kept[static_cast<size_t>(i)];
  size_ = count;
}

bool ConvexPolygon::Contains(const Eigen::Vector2d& p_m, double tolerance_m) const {
  if (size_ == 0) return false;
  for (int i = 0; i < size_; ++i) {
    const Eigen::Vector2d& a_m = vertices_[static_cast<size_t>(i)];
    const Eigen::Vector2d edge_m = vertices_[static_cast<size_t>((i + 1) % size_)] - a_m;
    // Left of every edge; an edge shorter than the tolerance has no direction worth asking.
    if (Cross(edge_m, p_m - a_m) < -tolerance_m * edge_m.norm()) return false;
  }
  // A polygon without area has no inside to be left of.
  if (size_ < 3) {
    const Eigen::Vector2d& a_m = vertices_[0];
    const Eigen::Vector2d& b_m = vertices_[static_cast<size_t>(size_ - 1)];
    return (p_m - a_m).norm() + (p_m - b_m).norm() <= (b_m - a_m).norm() + 2.0 * tolerance_m;
  }
  return true;
}

}  // namespace geon::geometry
