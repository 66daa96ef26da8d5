#include "geons/superquadric.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::geons {
namespace {

struct CurvePoint {
  Eigen::Vector2d p;         // on |x|^(2/e) + |y|^(2/e) = 1
  Eigen::Vector2d gradient;  // of (|x|^(2/e) + |y|^(2/e))^(e/2): homogeneous, so 1 along the ray
};

CurvePoint SuperellipseAt(double direction_rad, double exponent_1) {
  const double power_1 = 2.0 / exponent_1;
  const double c = std::cos(direction_rad), s = std::sin(direction_rad);
  // Scaled by the larger coordinate: powers of a hundred would underflow together otherwise.
  const double larger = std::max(c, s);
  const double radius =
      std::pow(std::pow(c / larger, power_1) + std::pow(s / larger, power_1), -1.0 / power_1) /
      larger;
  const Eigen::Vector2d p(radius * c, radius * s);
  return {p, {std::pow(p.x(), power_1 - 1.0), std::pow(p.y(), power_1 - 1.0)}};
}

// `steps` + 1 points of the first quadrant from the x to the y axis, at equal steps of arc length
// (with the axes' true lengths) and turning angle, each counted half.
std::vector<CurvePoint> QuarterSuperellipse(double exponent_1, const Eigen::Vector2d& axes_m,
                                            int steps) {
  constexpr int kFine = 8192;
  constexpr double kCrowding = 9.0;  // fine samples crowd round the diagonal, where the corner is
  std::vector<CurvePoint> fine(kFine + 1);
  std::vector<double> measure(kFine + 1, 0.0), length(kFine + 1, 0.0), angle(kFine + 1, 0.0);
  for (int i = 0; i <= kFine; ++i) {
    const double t = 2.0 * i / kFine - 1.0;
    const double direction_rad = std::clamp(
        0.25 * kPi * (1.0 + std::sinh(kCrowding * t) / std::sinh(kCrowding)), 0.0, 0.5 * kPi);
    const auto k = static_cast<size_t>(i);
    fine[k] = SuperellipseAt(direction_rad, exponent_1);
    if (i == 0) fine[k] = {{1.0, 0.0}, {1.0, 0.0}};
    if (i == kFine) fine[k] = {{0.0, 1.0}, {0.0, 1.0}};
    angle[k] = std::atan2(fine[k].gradient.y() / axes_m.y(), fine[k].gradient.x() / axes_m.x());
    if (i > 0) length[k] = length[k - 1] + (fine[k].p - fine[k - 1].p).cwiseProduct(axes_m).norm();
  }
  for (size_t k = 0; k < measure.size(); ++k) {
    measure[k] = 0.5 * length[k] / length.back() + 0.5 * angle[k] / (0.5 * kPi);
  }
  std::vector<CurvePoint> points;
  for (int i = 0; i <= steps; ++i) {
    const double wanted = static_cast<double>(i) / steps;
    const auto at = std::lower_bound(measure.begin(), measure.end(), wanted - 1e-12);
    points.push_back(fine[static_cast<size_t>(
        std::min<std::ptrdiff_t>(at - measure.begin(), static_cast<std::ptrdiff_t>(kFine)))]);
  }
  return points;
}

// The whole closed curve, 4 * steps points counter-clockwise from (1, 0).
std::vector<CurvePoint> ClosedSuperellipse(double exponent_1, const Eigen::Vector2d& axes_m,
                                           int around) {
  const int steps = around / 4;
  const std::vector<CurvePoint> quarter = QuarterSuperellipse(exponent_1, axes_m, steps);
  std::vector<CurvePoint> curve;
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    const Eigen::Vector2d sign(quadrant == 0 || quadrant == 3 ? 1 : -1, quadrant < 2 ? 1 : -1);
    for (int i = 0; i < steps; ++i) {
      const CurvePoint& point = quarter[static_cast<size_t>(quadrant % 2 == 0 ? i : steps - i)];
      curve.push_back({point.p.cwiseProduct(sign), point.gradient.cwiseProduct(sign)});
    }
  }
  return curve;
}

}  // namespace

TriangleMesh SuperquadricMesh(const Superquadric& shape, const MeshResolution& resolution) {
  Require(shape.half_axes_m.minCoeff() > 0.0, "SuperquadricMesh: half axes must be positive");
  Require(shape.profile_exponent_1 > 0.0 && shape.section_exponent_1 > 0.0,
          "SuperquadricMesh: exponents must be positive");
  Require(resolution.around >= 8 && resolution.around % 4 == 0 && resolution.along >= 4 &&
              resolution.along % 2 == 0,
          "SuperquadricMesh: around must be a multiple of 4, along of 2");
  const Eigen::Vector3d& a_m = shape.half_axes_m;
  const std::vector<CurvePoint> section =
      ClosedSuperellipse(shape.section_exponent_1, a_m.head<2>(), resolution.around);
  const int half = resolution.along / 2;
  const std::vector<CurvePoint> profile =
      QuarterSuperellipse(shape.profile_exponent_1, {std::max(a_m.x(), a_m.y()), a_m.z()}, half);

  TriangleMesh mesh;
  const auto add = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& gradient) {
    mesh.vertices_m.push_back(p.cwiseProduct(a_m));
    mesh.normals.push_back(gradient.cwiseQuotient(a_m).normalized());
  };
  add(-Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitZ());
  for (int i = 1 - half; i < half; ++i) {
    const CurvePoint& ring = profile[static_cast<size_t>(std::abs(i))];
    const double side = i < 0 ? -1.0 : 1.0;
    for (const CurvePoint& point : section) {
      add({ring.p.x() * point.p.x(), ring.p.x() * point.p.y(), side * ring.p.y()},
          {ring.gradient.x() * point.gradient.x(), ring.gradient.x() * point.gradient.y(),
           side * ring.gradient.y()});
    }
  }
  add(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ());

  const int n = resolution.around;
  const int rings = 2 * half - 1;
  const int top = 1 + rings * n;
  for (int j = 0; j < n; ++j) {
    const int next = (j + 1) % n;
    mesh.triangles.push_back({0, 1 + next, 1 + j});
    for (int ring = 0; ring + 1 < rings; ++ring) {
      const int low = 1 + ring * n, high = low + n;
      mesh.triangles.push_back({low + j, low + next, high + next});
      mesh.triangles.push_back({low + j, high + next, high + j});
    }
    mesh.triangles.push_back({top - n + j, top - n + next, top});
  }
  return mesh;
}

void TaperAlongZ(const Eigen::Vector2d& rate_per_m, TriangleMesh* mesh) {
  for (size_t k = 0; k < mesh->vertices_m.size(); ++k) {
    Eigen::Vector3d& p = mesh->vertices_m[k];
    Eigen::Vector3d& n = mesh->normals[k];
    const Eigen::Array2d scale = 1.0 + rate_per_m.array() * p.z();
    const Eigen::Array2d across = n.head<2>().array() / scale;
    n = Eigen::Vector3d(across.x(), across.y(),
                        n.z() - (rate_per_m.array() * p.head<2>().array() * across).sum())
            .normalized();
    p.head<2>().array() *= scale;
  }
}

void BendAlongZ(double curvature_per_m, TriangleMesh* mesh) {
  Require(curvature_per_m > 0.0, "BendAlongZ: the curvature must be positive");
  const double radius_m = 1.0 / curvature_per_m;
  for (size_t k = 0; k < mesh->vertices_m.size(); ++k) {
    Eigen::Vector3d& p = mesh->vertices_m[k];
    Eigen::Vector3d& n = mesh->normals[k];
    const double angle_rad = p.z() * curvature_per_m;
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    const double stretch = 1.0 - p.x() * curvature_per_m;
    Require(stretch > 0.0, "BendAlongZ: the shape reaches the centre of curvature");
    // The columns of the deformation's Jacobian are orthogonal: its inverse transpose divides by
    // lengths.
    n = (n.x() * Eigen::Vector3d(c, 0, -s) + n.y() * Eigen::Vector3d::UnitY() +
         n.z() / stretch * Eigen::Vector3d(s, 0, c))
            .normalized();
    p = Eigen::Vector3d(radius_m - (radius_m - p.x()) * c, p.y(), (radius_m - p.x()) * s);
  }
}

}  // namespace geon::geons
