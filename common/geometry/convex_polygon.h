#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

namespace geon::geometry {

// The points p of a plane with normal . p <= offset_m; the normal has unit length.
struct HalfPlane {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double offset_m = 0.0;

  // How far p lies inside (positive) or outside (negative).
  double Depth(const Eigen::Vector2d& p_m) const { return offset_m - normal.dot(p_m); }
};

// A convex polygon, vertices counter-clockwise, at most kMaxVertices of them; held in place, so
// that cutting it allocates nothing. It may degenerate (a segment, a point) and may become empty.
class ConvexPolygon {
 public:
  static constexpr int kMaxVertices = 64;

  // The box [-half_x_m, half_x_m] x [-half_y_m, half_y_m].
  static ConvexPolygon Box(double half_x_m, double half_y_m);

  // Keeps the part inside `half_plane` (Sutherland-Hodgman on a convex polygon: one vertex more at
  // most).
  void Clip(const HalfPlane& half_plane);

  bool empty() const { return size_ == 0; }
  std::span<const Eigen::Vector2d> vertices() const {
    return {vertices_.data(), static_cast<size_t>(size_)};
  }
  // Whether p lies inside or within `tolerance_m` of it.
  bool Contains(const Eigen::Vector2d& p_m, double tolerance_m = 1e-9) const;

 private:
  std::array<Eigen::Vector2d, kMaxVertices> vertices_{};
  int size_ = 0;
};

}  // namespace geon::geometry
