#include "sim/footprint.h"

#include <algorithm>
#include <limits>

#include "base/contracts.h"

namespace geon::sim {
namespace {

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

std::vector<Eigen::Vector2d> ConvexFootprint(const geons::TriangleMesh& mesh) {
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector3d& p : mesh.vertices_m) points.push_back(p.head<2>());
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  // Andrew's monotone chain: the lower hull, then the upper one on the way back.
  std::vector<Eigen::Vector2d> hull;
  const auto add = [&hull](const Eigen::Vector2d& p, size_t floor) {
    while (hull.size() >= floor + 2 &&
           Cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Eigen::Vector2d& p : points) add(p, 0);
  const size_t lower = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
  hull.pop_back();
  return hull;
}

NearestPoint NearestPointOfConvex(const std::vector<Eigen::Vector2d>& polygon_m,
                                  const Eigen::Vector2d& point_m) {
  Require(!polygon_m.empty(), "NearestPointOfConvex: the polygon has no vertices");
  bool inside = polygon_m.size() > 2;
  NearestPoint nearest;
  nearest.distance_m = std::numeric_limits<double>::infinity();
  for (size_t k = 0; k < polygon_m.size(); ++k) {
    const Eigen::Vector2d& a = polygon_m[k];
    const Eigen::Vector2d edge = polygon_m[(k + 1) % polygon_m.size()] - a;
    const double length2_m2 = edge.squaredNorm();
    if (Cross(edge, point_m - a) < 0.0) inside = false;
    const double t =
        length2_m2 > 0.0 ? std::clamp((point_m - a).dot(edge) / length2_m2, 0.0, 1.0) : 0.0;
    const Eigen::Vector2d to_edge_m = a + t * edge - point_m;
    const double distance_m = to_edge_m.norm();
    if (distance_m >= nearest.distance_m) continue;
    nearest.distance_m = distance_m;
    // On the edge itself the direction is the edge's inward normal.
    nearest.direction = distance_m > 1e-12 ? Eigen::Vector2d(to_edge_m / distance_m)
                                           : Eigen::Vector2d(-edge.y(), edge.x()).normalized();
  }
  if (inside) {
    nearest.distance_m = -nearest.distance_m;
    nearest.direction = -nearest.direction;
  }
  return nearest;
}

double DistanceAlongRay(const std::vector<Eigen::Vector2d>& polygon_m,
                        const Eigen::Vector2d& from_m, const Eigen::Vector2d& direction) {
  constexpr double kEndless_m = std::numeric_limits<double>::infinity();
  double enters_m = 0.0;
  double leaves_m = kEndless_m;
  for (size_t k = 0; k < polygon_m.size(); ++k) {
    const Eigen::Vector2d edge = polygon_m[(k + 1) % polygon_m.size()] - polygon_m[k];
    // Left of the edge is inside: how far from it, and how fast that grows along the ray.
    const double inside = Cross(edge, from_m - polygon_m[k]);
    const double grows = Cross(edge, direction);
    if (grows > 0.0) {
      enters_m = std::max(enters_m, -inside / grows);
    } else if (grows < 0.0) {
      leaves_m = std::min(leaves_m, -inside / grows);
    } else if (inside < 0.0) {
      return kEndless_m;
    }
  }
  return enters_m <= leaves_m ? enters_m : kEndless_m;
}

}  // namespace geon::sim
