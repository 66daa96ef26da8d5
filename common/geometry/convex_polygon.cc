#include "geometry/convex_polygon.h"

#include <algorithm>

#include "base/contracts.h"

namespace geon::geometry {

namespace {

// A line that cuts off no more than this adds no side; nor does one so nearly parallel to its
// neighbour (as a sine) that they have no corner to speak of.
constexpr double kNothing_m = 1e-9;
constexpr double kParallel_1 = 1e-9;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Where two lines meet.
Eigen::Vector2d Corner(const HalfPlane& a, const HalfPlane& b) {
  return Eigen::Vector2d(a.offset_m * b.normal.y() - b.offset_m * a.normal.y(),
                         b.offset_m * a.normal.x() - a.offset_m * b.normal.x()) /
         Cross(a.normal, b.normal);
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

ConvexPolygon ConvexPolygon::Intersection(std::span<const HalfPlane> by_bearing) {
  Require(by_bearing.size() >= 3 && by_bearing.size() <= kMaxVertices,
          "ConvexPolygon::Intersection: 3 to 64 half-planes");
  // The nearest line has a side for sure: the foot of its perpendicular is inside all the others.
  const auto nearest = std::min_element(
      by_bearing.begin(), by_bearing.end(),
      [](const HalfPlane& a, const HalfPlane& b) { return a.offset_m < b.offset_m; });
  Require(nearest->offset_m > 0.0, "ConvexPolygon::Intersection: the origin must lie inside");
  ConvexPolygon polygon;
  std::array<const HalfPlane*, kMaxVertices> sides{&*nearest};
  size_t last = 0;  // side; vertex k lies between the sides k and k + 1
  const auto drop_sides_beyond = [&](const HalfPlane& line) {
    while (last > 0 && line.Depth(polygon.vertices_[last - 1]) <= kNothing_m) --last;
  };
  const auto add = [&](const HalfPlane& line) {
    drop_sides_beyond(line);
    if (Cross(sides[last]->normal, line.normal) <= kParallel_1 &&
        line.offset_m >= sides[last]->offset_m) {
      return;
    }
    polygon.vertices_[last] = Corner(*sides[last], line);
    sides[++last] = &line;
  };
  std::for_each(nearest + 1, by_bearing.end(), add);
  std::for_each(by_bearing.begin(), nearest, add);
  drop_sides_beyond(*nearest);
  polygon.vertices_[last] = Corner(*sides[last], *nearest);
  polygon.size_ = static_cast<int>(last) + 1;
  return polygon;
}

bool ConvexPolygon::Contains(const Eigen::Vector2d& p_m, double tolerance_m) const {
  for (int i = 0; i < size_; ++i) {
    const Eigen::Vector2d& a_m = vertices_[static_cast<size_t>(i)];
    const Eigen::Vector2d edge_m = vertices_[static_cast<size_t>((i + 1) % size_)] - a_m;
    // Left of every edge; an edge shorter than the tolerance has no direction worth asking.
    if (Cross(edge_m, p_m - a_m) < -tolerance_m * edge_m.norm()) return false;
  }
  return size_ > 0;
}

}  // namespace geon::geometry
