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
// that making one allocates nothing.
class ConvexPolygon {
 public:
  static constexpr int kMaxVertices = 64;

  // The box [-half_x_m, half_x_m] x [-half_y_m, half_y_m].
  static ConvexPolygon Box(double half_x_m, double half_y_m);

  // The intersection of at most kMaxVertices half-planes that all hold the origin inside
  // (offset_m > 0). They come in the order of their normals' bearings, which turn once around
  // counter-clockwise, each by less than half a turn; so the intersection is bounded.
  //
  // Source: Graham's scan (1972) on the dual points normal / offset_m, whose convex hull's corners
  // are the lines that bound the intersection: from the nearest line once around, a line is dropped
  // when it lies beyond the corner of its neighbours. In proportion to their number.
  static ConvexPolygon Intersection(std::span<const HalfPlane> by_bearing);

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
