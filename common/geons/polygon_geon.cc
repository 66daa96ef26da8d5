#include "geons/polygon_geon.h"

#include <cmath>
#include <utility>
#include <vector>

#include "base/angles.h"
#include "base/contracts.h"
#include "geons/stable_position.h"

namespace geon::geons {
namespace {

using Ring = std::vector<Eigen::Vector3d>;

constexpr double kCrease_rad = RadiansFromDegrees(20.0);
constexpr double kArcStep_rad = RadiansFromDegrees(4.0);

// Corners of the section, counter-clockwise from above, within [-0.5, 0.5] of each axis.
std::vector<Eigen::Vector2d> UnitSection(GeonLabel label, int sides) {
  if (!IsRound(label)) return {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  const double step_rad = 2.0 * kPi / sides;
  const double radius = 0.5 * std::sqrt(step_rad / std::sin(step_rad));  // the circle's area
  std::vector<Eigen::Vector2d> section;
  for (int k = 0; k < sides; ++k) {
    const double angle_rad = (k + 0.5) * step_rad;
    section.emplace_back(radius * std::cos(angle_rad), radius * std::sin(angle_rad));
  }
  return section;
}

// The section at `height_1` (-0.5 bottom, 0.5 top) of the upright geon.
Ring RingAt(const GeonShape& shape, const std::vector<Eigen::Vector2d>& section, double height_1) {
  double width_1 = 1.0;
  if (IsTapered(shape.label)) {
    const double small_end = (1.0 - shape.taper_1) / (1.0 + shape.taper_1);
    width_1 = 1.0 - (0.5 + height_1) * (1.0 - small_end);
  } else if (shape.label == GeonLabel::kEllipsoid) {
    width_1 = std::sqrt(std::max(0.0, 1.0 - 4.0 * height_1 * height_1));
  }
  Ring ring;
  for (const Eigen::Vector2d& corner : section) {
    const double x_m = width_1 * corner.x() * shape.size_m.x();
    const double y_m = width_1 * corner.y() * shape.size_m.y();
    if (!IsBent(shape.label)) {
      ring.emplace_back(x_m, y_m, height_1 * shape.size_m.z());
      continue;
    }
    const double radius_m = shape.size_m.z() / shape.bend_rad;
    const double angle_rad = height_1 * shape.bend_rad;
    ring.emplace_back(radius_m - (radius_m - x_m) * std::cos(angle_rad), y_m,
                      (radius_m - x_m) * std::sin(angle_rad));
  }
  return ring;
}

std::vector<double> Heights(const GeonShape& shape, int sides) {
  int steps = 1;
  if (IsBent(shape.label)) steps = static_cast<int>(std::ceil(shape.bend_rad / kArcStep_rad));
  if (shape.label != GeonLabel::kEllipsoid) {
    std::vector<double> heights;
    for (int k = 0; k <= steps; ++k) heights.push_back(static_cast<double>(k) / steps - 0.5);
    return heights;
  }
  std::vector<double> heights;  // equal angles; the poles are left to small flat caps
  steps = sides / 2;
  for (int k = 0; k < steps; ++k) heights.push_back(-0.5 * std::cos((k + 0.5) * kPi / steps));
  return heights;
}

// The surface through the rings, from the first to the last, with flat ends.
TriangleMesh Loft(const std::vector<Ring>& rings) {
  TriangleMesh mesh;
  const int n = static_cast<int>(rings.front().size());
  for (const Ring& ring : rings) {
    mesh.vertices_m.insert(mesh.vertices_m.end(), ring.begin(), ring.end());
  }
  const int count = static_cast<int>(rings.size());
  for (int ring = 0; ring + 1 < count; ++ring) {
    for (int j = 0; j < n; ++j) {
      const int a = ring * n + j, b = ring * n + (j + 1) % n;
      mesh.triangles.push_back({a, b, b + n});
      mesh.triangles.push_back({a, b + n, a + n});
    }
  }
  const int top = (count - 1) * n;
  for (int j = 1; j + 1 < n; ++j) {
    mesh.triangles.push_back({0, j + 1, j});
    mesh.triangles.push_back({top, top + j, top + j + 1});
  }
  return mesh;
}

}  // namespace

TriangleMesh PolygonGeon(const GeonShape& shape, int sides) {
  const Status valid = Validate(shape);
  Require(valid.ok(), "PolygonGeon: " + valid.message());
  Require(sides >= 6, "PolygonGeon: a round section needs at least 6 sides");
  const std::vector<Eigen::Vector2d> section = UnitSection(shape.label, sides);
  std::vector<Ring> rings;
  for (double height_1 : Heights(shape, sides)) rings.push_back(RingAt(shape, section, height_1));
  TriangleMesh mesh = Loft(rings);
  for (Eigen::Vector3d& p_m : mesh.vertices_m) p_m = StablePositionRotation(shape) * p_m;
  StandOnGround(&mesh);
  return WithFaceNormals(mesh, kCrease_rad);
}

TriangleMesh PolygonVessel(const GeonShape& shape, double wall_1, int sides) {
  const Status valid = Validate(shape);
  Require(valid.ok(), "PolygonVessel: " + valid.message());
  Require(!IsBent(shape.label) && shape.label != GeonLabel::kEllipsoid,
          "PolygonVessel: only a cuboid or cylinder, tapered or not, can be a vessel");
  Require(wall_1 > 0.0 && wall_1 < 1.0, "PolygonVessel: wall_1 must be within 0 and 1");
  const std::vector<Eigen::Vector2d> section = UnitSection(shape.label, sides);
  const bool wide_top = IsTapered(shape.label) && shape.position == 3;
  const auto ring = [&](double height_1, double inner_1, double lift_1) {
    Ring points = RingAt(shape, section, wide_top ? -height_1 : height_1);
    for (Eigen::Vector3d& p_m : points) {
      p_m.head<2>() *= inner_1;
      p_m.z() = (height_1 + lift_1) * shape.size_m.z();
    }
    return points;
  };
  const double floor_1 = 0.5 * wall_1 * shape.size_m.x() / shape.size_m.z();
  TriangleMesh mesh = Loft({ring(-0.5, 1.0, 0.0), ring(0.5, 1.0, 0.0), ring(0.5, 1.0 - wall_1, 0.0),
                            ring(-0.5, 1.0 - wall_1, floor_1)});
  StandOnGround(&mesh);
  return WithFaceNormals(mesh, kCrease_rad);
}

}  // namespace geon::geons
