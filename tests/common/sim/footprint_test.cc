#include "sim/footprint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/contracts.h"

namespace geon::sim {
namespace {

geons::TriangleMesh Points(std::vector<Eigen::Vector3d> points) {
  geons::TriangleMesh mesh;
  mesh.vertices_m = std::move(points);
  return mesh;
}

TEST(FootprintTest, HullLeavesOutWhatLiesInside) {
  const auto hull = ConvexFootprint(
      Points({{0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 9}, {0.5, 0, 0}}));
  ASSERT_EQ(hull.size(), 4u);
  double twice_area = 0.0;
  for (size_t k = 0; k < 4; ++k) {
    const auto &a = hull[k], &b = hull[(k + 1) % 4];
    twice_area += a.x() * b.y() - a.y() * b.x();
  }
  EXPECT_DOUBLE_EQ(twice_area, 2.0);  // positive: counter-clockwise
}

TEST(FootprintTest, NearestPointOfEdgesCornersAndInside) {
  const std::vector<Eigen::Vector2d> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_DOUBLE_EQ(NearestPointOfConvex(square, {0.5, -2.0}).distance_m, 2.0);
  EXPECT_DOUBLE_EQ(NearestPointOfConvex(square, {4.0, 5.0}).distance_m, 5.0);
  const NearestPoint inside = NearestPointOfConvex(square, {0.9, 0.5});
  EXPECT_NEAR(inside.distance_m, -0.1, 1e-12);
  EXPECT_NEAR((inside.direction - Eigen::Vector2d(-1, 0)).norm(), 0.0, 1e-12);
  const NearestPoint on_edge = NearestPointOfConvex(square, {0.5, 0.0});
  EXPECT_NEAR((on_edge.direction.cwiseAbs() - Eigen::Vector2d(0, 1)).norm(), 0.0, 1e-12);
}

TEST(FootprintTest, ARayMeetsWhatLiesAheadOfIt) {
  const std::vector<Eigen::Vector2d> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_DOUBLE_EQ(DistanceAlongRay(square, {-2.0, 0.5}, {1, 0}), 2.0);
  EXPECT_DOUBLE_EQ(DistanceAlongRay(square, {0.5, -1.0}, Eigen::Vector2d(0.1, 1).normalized()),
                   std::hypot(0.1, 1.0));
  EXPECT_DOUBLE_EQ(DistanceAlongRay(square, {0.3, 0.5}, {1, 0}), 0.0);
  EXPECT_TRUE(std::isinf(DistanceAlongRay(square, {-2.0, 0.5}, {-1, 0}))) << "behind";
  EXPECT_TRUE(std::isinf(DistanceAlongRay(square, {-2.0, 1.5}, {1, 0}))) << "beside";
  EXPECT_TRUE(
      std::isinf(DistanceAlongRay(square, {-2.0, 0.5}, Eigen::Vector2d(1, 1).normalized())));
}

TEST(FootprintTest, NoPolygonIsAContractViolation) {
  EXPECT_THROW(NearestPointOfConvex({}, {0, 0}), ContractViolation);
}

}  // namespace
}  // namespace geon::sim
