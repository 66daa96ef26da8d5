#include "geons/superquadric.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::geons {
namespace {

// Beta function form of a superquadric's volume (Solina and Bajcsy 1990; Jaklic et al. 2000,
// eq. 2.60).
double SuperquadricVolume(const Superquadric& s) {
  const auto beta = [](double x, double y) {
    return std::exp(std::lgamma(x) + std::lgamma(y) - std::lgamma(x + y));
  };
  const double e1 = s.profile_exponent_1, e2 = s.section_exponent_1;
  return 2.0 * s.half_axes_m.prod() * e1 * e2 * beta(e1 / 2 + 1, e1) * beta(e2 / 2, e2 / 2);
}

class SuperquadricMeshTest : public ::testing::TestWithParam<std::pair<double, double>> {};

TEST_P(SuperquadricMeshTest, ClosedWithTheVolumeOfTheFormula) {
  const auto [e1, e2] = GetParam();
  const Superquadric shape{{0.10, 0.07, 0.15}, e1, e2};
  const TriangleMesh mesh = SuperquadricMesh(shape, {});
  EXPECT_TRUE(IsClosed(mesh));
  EXPECT_NEAR(Volume(mesh) / SuperquadricVolume(shape), 1.0, 2e-3);
  EXPECT_NEAR((Bounds(mesh).sizes() - 2.0 * shape.half_axes_m).norm(), 0.0, 1e-9);
}

TEST_P(SuperquadricMeshTest, VerticesLieOnTheSurfaceAndNormalsFaceOutward) {
  const auto [e1, e2] = GetParam();
  const Superquadric shape{{0.10, 0.07, 0.15}, e1, e2};
  const TriangleMesh mesh = SuperquadricMesh(shape, {});
  for (size_t k = 0; k < mesh.vertices_m.size(); k += 7) {
    const Eigen::Vector3d q = mesh.vertices_m[k].cwiseQuotient(shape.half_axes_m).cwiseAbs();
    const double section = std::pow(std::pow(q.x(), 2 / e2) + std::pow(q.y(), 2 / e2), e2 / 2);
    const double inside_out = std::pow(std::pow(section, 2 / e1) + std::pow(q.z(), 2 / e1), e1 / 2);
    EXPECT_NEAR(inside_out, 1.0, 1e-9);
    EXPECT_NEAR(mesh.normals[k].norm(), 1.0, 1e-9);
    EXPECT_GT(mesh.normals[k].dot(mesh.vertices_m[k]), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Exponents, SuperquadricMeshTest,
                         ::testing::Values(std::pair{1.0, 1.0}, std::pair{0.02, 1.0},
                                           std::pair{0.02, 0.02}, std::pair{0.3, 0.6}));

// Normals must stay perpendicular to the faces round them through a deformation.
double WorstNormalError(const TriangleMesh& mesh) {
  double worst_rad = 0.0;
  for (const auto& corners : mesh.triangles) {
    const auto& v = mesh.vertices_m;
    const Eigen::Vector3d a = v[static_cast<size_t>(corners[0])],
                          b = v[static_cast<size_t>(corners[1])],
                          c = v[static_cast<size_t>(corners[2])];
    const Eigen::Vector3d face = (b - a).cross(c - a);
    if (face.norm() < 1e-9) continue;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (int corner : corners) mean += mesh.normals[static_cast<size_t>(corner)];
    worst_rad =
        std::max(worst_rad, std::acos(std::min(1.0, face.normalized().dot(mean.normalized()))));
  }
  return worst_rad;
}

TEST(DeformationTest, TaperScalesTheEndsAndTurnsTheNormals) {
  TriangleMesh mesh = SuperquadricMesh({{0.1, 0.1, 0.2}, 1.0, 1.0}, {});
  EXPECT_LT(WorstNormalError(mesh), 0.05);
  TaperAlongZ({-2.0, -2.0}, &mesh);
  EXPECT_LT(WorstNormalError(mesh), 0.05);
  for (const Eigen::Vector3d& p : mesh.vertices_m) {
    const double scale = 1.0 - 2.0 * p.z();
    EXPECT_LE(p.head<2>().norm(),
              0.1 * scale * std::sqrt(std::max(0.0, 1.0 - p.z() * p.z() / 0.04)) + 1e-9);
  }
}

TEST(DeformationTest, BendKeepsTheAxisLengthAndTurnsTheNormals) {
  TriangleMesh mesh = SuperquadricMesh({{0.03, 0.04, 0.15}, 1.0, 1.0}, {});
  const double volume_before_m3 = Volume(mesh);
  const double curvature_per_m = RadiansFromDegrees(120) / 0.3;
  BendAlongZ(curvature_per_m, &mesh);
  EXPECT_LT(WorstNormalError(mesh), 0.08);
  EXPECT_TRUE(IsClosed(mesh));
  EXPECT_NEAR(Volume(mesh), volume_before_m3, 2e-3 * volume_before_m3);  // Pappus
  // The poles sit at the ends of an arc of 120 degrees round (1/curvature, 0, 0).
  const Eigen::Vector3d centre(1.0 / curvature_per_m, 0, 0);
  const Eigen::Vector3d low = mesh.vertices_m.front() - centre,
                        high = mesh.vertices_m.back() - centre;
  EXPECT_NEAR(low.norm(), 1.0 / curvature_per_m, 1e-9);
  EXPECT_NEAR(std::acos(low.normalized().dot(high.normalized())), RadiansFromDegrees(120), 1e-9);
}

TEST(DeformationTest, BendThroughTheCentreOfCurvatureIsAContractViolation) {
  TriangleMesh mesh = SuperquadricMesh({{0.2, 0.1, 0.2}, 1.0, 1.0}, {});
  EXPECT_THROW(BendAlongZ(6.0, &mesh), ContractViolation);
}

}  // namespace
}  // namespace geon::geons
