#pragma once

#include <Eigen/Core>
#include <vector>

#include "geons/triangle_mesh.h"

namespace geon::sim {

// The outline of a body from above as its convex hull, counter-clockwise.
std::vector<Eigen::Vector2d> ConvexFootprint(const geons::TriangleMesh& mesh);

struct NearestPoint {
  double distance_m = 0.0;  // negative inside
  Eigen::Vector2d direction =
      Eigen::Vector2d::UnitX();  // unit, from the asking point into the polygon
};

// How far a point is from a convex counter-clockwise polygon of at least one vertex.
NearestPoint NearestPointOfConvex(const std::vector<Eigen::Vector2d>& polygon_m,
                                  const Eigen::Vector2d& point_m);

// How far it is along a ray (of unit direction) to such a polygon of at least three vertices: 0
// from inside, infinite where the ray passes it. Of less than three it may be told too short.
double DistanceAlongRay(const std::vector<Eigen::Vector2d>& polygon_m,
                        const Eigen::Vector2d& from_m, const Eigen::Vector2d& direction);

}  // namespace geon::sim
