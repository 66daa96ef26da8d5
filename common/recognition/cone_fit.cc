#include "recognition/cone_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/angles.h"

namespace geon::recognition {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

constexpr size_t kFewestOnCone = 12;
// Of Tukey's biweight, in tolerances, one step each.
constexpr std::array<double, 5> kWidths = {20.0, 12.0, 7.0, 5.0, 4.0};
constexpr int kLastSteps = 3;
constexpr double kLateral_rad = RadiansFromDegrees(15.0);
constexpr double kFewestTurn_rad = RadiansFromDegrees(15.0);
constexpr double kSteepest_1 = 1.0;     // slope: a cone of 90 degrees
constexpr double kLargestRadius = 3.0;  // in extents of the points
constexpr double kDamping = 1e-3;

// Two directions at right angles to the axis and to each other.
struct Across {
  Eigen::Vector3d u, v;
  explicit Across(const Eigen::Vector3d& axis) : u(axis.unitOrthogonal()), v(axis.cross(u)) {}
};

// Whether a normal is at right angles to the axis, as on the side of a cylinder.
bool IsLateral(const Eigen::Vector3d& axis, const Eigen::Vector3d& normal) {
  return std::abs(axis.dot(normal)) < std::sin(kLateral_rad);
}

// The direction that is at right angles to most of the normals, or along them.
Eigen::Vector3d AxisOfNormals(std::span<const OrientedPoint> oriented) {
  Eigen::Vector3d best = Eigen::Vector3d::UnitX();
  double best_score = 0.0;
  for (size_t a = 0; a < oriented.size(); ++a) {
    for (size_t b = 0; b < a; ++b) {
      const Eigen::Vector3d cross = oriented[a].normal_L.cross(oriented[b].normal_L);
      const double length = cross.norm();
      if (length < std::sin(kFewestTurn_rad)) continue;
      double score = 0.0;
      for (const OrientedPoint& point : oriented) {
        const double along = std::abs(point.normal_L.dot(cross)) / length;
        const double off = std::min(along, 1.0 - along) / std::sin(kLateral_rad);
        score += std::max(0.0, 1.0 - off * off);
      }
      if (score <= best_score) continue;
      best_score = score;
      best = cross / length;
    }
  }
  return best;
}

// The cylinder round `axis` whose centre lies one radius below every lateral point. Nothing with
// fewer than two such points, or when they face the same way.
std::optional<Cone> StartingCylinder(std::span<const OrientedPoint> oriented,
                                     const Eigen::Vector3d& middle_m, const Eigen::Vector3d& axis,
                                     double extent_m) {
  const Across across(axis);
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();  // of centre along u and v, and radius
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const OrientedPoint& point : oriented) {
    if (!IsLateral(axis, point.normal_L)) continue;
    for (const Eigen::Vector3d& side : {across.u, across.v}) {
      const Eigen::Vector3d row(side.dot(across.u), side.dot(across.v), side.dot(point.normal_L));
      A += row * row.transpose();
      b += row * side.dot(point.p_L_m - middle_m);
    }
  }
  if (A.determinant() < 1e-3) return std::nullopt;
  const Eigen::Vector3d fit = A.ldlt().solve(b);
  Cone cone;
  cone.p_L_m = across.u * fit.x() + across.v * fit.y();
  cone.axis_L = axis;
  cone.radius_m = std::clamp(fit.z(), 0.02 * extent_m, kLargestRadius * extent_m);
  return cone;
}

struct Residual {
  double off_m = 0.0;
  Vector6d gradient;  // by p along u and v, axis along u and v, radius, slope
};

Residual Off(const Cone& cone, const Across& across, const Eigen::Vector3d& p_m) {
  const Eigen::Vector3d q = p_m - cone.p_L_m;
  const double qu = q.dot(across.u), qv = q.dot(across.v), s = q.dot(cone.axis_L);
  const double rho = std::max(std::sqrt(qu * qu + qv * qv), 1e-9);
  const double turn = -s / rho - cone.slope_1;
  Residual residual;
  residual.off_m = rho - cone.radius_m - cone.slope_1 * s;
  residual.gradient << -qu / rho, -qv / rho, turn * qu, turn * qv, -1.0, -s;
  return residual;
}

// What the points say of a change of the cone, each weighed by how near it lies.
struct NormalEquations {
  Matrix6d information = Matrix6d::Zero();
  Vector6d right = Vector6d::Zero();
  double weights = 0.0;
  double squares_m2 = 0.0;
};

NormalEquations Linearize(std::span<const Eigen::Vector3d> points_m, double reach_m,
                          const Cone& cone, const Across& across) {
  NormalEquations equations;
  for (const Eigen::Vector3d& p_m : points_m) {
    const Residual residual = Off(cone, across, p_m);
    const double share = residual.off_m / reach_m;
    const double inside = 1.0 - share * share;
    if (inside <= 0.0) continue;
    const double weight = inside * inside;
    const Vector6d weighted = weight * residual.gradient;
    equations.information.noalias() += weighted * residual.gradient.transpose();
    equations.right -= residual.off_m * weighted;
    equations.weights += weight;
    equations.squares_m2 += weight * residual.off_m * residual.off_m;
  }
  equations.information.diagonal().array() += 1e-9;
  return equations;
}

void Step(std::span<const Eigen::Vector3d> points_m, double reach_m, double extent_m, Cone* cone) {
  const Across across(cone->axis_L);
  const NormalEquations equations = Linearize(points_m, reach_m, *cone, across);
  Matrix6d information = equations.information;
  information.diagonal() *= 1.0 + kDamping;
  const Vector6d step = information.ldlt().solve(equations.right);
  if (!step.allFinite()) return;
  const double longest_m = 0.3 * extent_m;
  cone->p_L_m += (across.u * step[0] + across.v * step[1]).cwiseMax(-longest_m).cwiseMin(longest_m);
  cone->axis_L = (cone->axis_L + across.u * std::clamp(step[2], -0.3, 0.3) +
                  across.v * std::clamp(step[3], -0.3, 0.3))
                     .normalized();
  cone->radius_m = std::clamp(cone->radius_m + step[4], 1e-3, kLargestRadius * extent_m);
  cone->slope_1 = std::clamp(cone->slope_1 + step[5], -kSteepest_1, kSteepest_1);
}

// How far the slope may be off, from how far the points lie off and how well they hold it.
double SlopeSigma(std::span<const Eigen::Vector3d> points_m, double reach_m, const Cone& cone) {
  const NormalEquations equations = Linearize(points_m, reach_m, cone, Across(cone.axis_L));
  const double variance_m2 = equations.squares_m2 / std::max(equations.weights - 6.0, 1.0);
  const Vector6d by_slope = equations.information.ldlt().solve(Vector6d::Unit(5));
  return std::sqrt(std::max(variance_m2 * by_slope[5], 0.0));
}

double Misfit(std::span<const Eigen::Vector3d> points_m, double tolerance_m, const Cone& cone) {
  const Across across(cone.axis_L);
  double sum = 0.0;
  for (const Eigen::Vector3d& p_m : points_m) {
    const double share = Off(cone, across, p_m).off_m / tolerance_m;
    sum += std::min(1.0, share * share);
  }
  return sum / static_cast<double>(points_m.size());
}

}  // namespace

Cone FitCone(std::span<const Eigen::Vector3d> given_m, std::span<const OrientedPoint> oriented,
             double tolerance_m) {
  Cone best;
  if (given_m.size() < kFewestOnCone) return best;
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p_m : given_m) middle_m += p_m / static_cast<double>(given_m.size());
  std::vector<Eigen::Vector3d> points_m(given_m.begin(), given_m.end());
  double extent_m = 0.0;
  for (Eigen::Vector3d& p_m : points_m) {
    p_m -= middle_m;
    extent_m = std::max(extent_m, p_m.norm());
  }
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0.0, 0.0, 1.0), AxisOfNormals(oriented)}) {
    std::optional<Cone> cone = StartingCylinder(oriented, middle_m, axis, extent_m);
    if (!cone) continue;
    for (double width : kWidths) Step(points_m, width * tolerance_m, extent_m, &*cone);
    cone->misfit_1 = Misfit(points_m, tolerance_m, *cone);
    if (cone->misfit_1 < best.misfit_1) best = *cone;
  }
  if (best.misfit_1 >= 1.0) return best;
  for (int k = 0; k < kLastSteps; ++k)
    Step(points_m, kWidths.back() * tolerance_m, extent_m, &best);
  best.misfit_1 = Misfit(points_m, tolerance_m, best);
  best.slope_sigma_1 = SlopeSigma(points_m, kWidths.back() * tolerance_m, best);
  // Level with the points' middle, which is the origin here.
  const double along_m = -best.p_L_m.dot(best.axis_L);
  best.radius_m += best.slope_1 * along_m;
  best.p_L_m += along_m * best.axis_L + middle_m;
  return best;
}

}  // namespace geon::recognition
