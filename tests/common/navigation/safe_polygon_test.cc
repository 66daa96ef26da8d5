#include "navigation/safe_polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "base/contracts.h"

namespace geon::navigation {
namespace {

using Eigen::Vector2d;

double DistanceToPolygon(const geometry::ConvexPolygon& polygon, const Vector2d& p_m) {
  double nearest_m = 1e9;
  const auto vertices = polygon.vertices();
  for (size_t i = 0; i < vertices.size(); ++i) {
    const Vector2d a_m = vertices[i];
    const Vector2d edge_m = vertices[(i + 1) % vertices.size()] - a_m;
    const double squared_m2 = edge_m.squaredNorm();
    const double t =
        squared_m2 > 0.0 ? std::clamp((p_m - a_m).dot(edge_m) / squared_m2, 0.0, 1.0) : 0.0;
    nearest_m = std::min(nearest_m, (p_m - a_m - t * edge_m).norm());
  }
  return nearest_m;
}

TEST(SafePolygonTest, WithoutObstaclesItIsTheDefaultBox) {
  const SafePolygonOptions options;
  const auto polygon = SafePolygon({}, options);
  ASSERT_EQ(polygon.vertices().size(), 4u);
  EXPECT_TRUE(polygon.Contains({options.default_box_m - 0.01, options.default_box_m - 0.01}));
}

TEST(SafePolygonTest, OneObstacleDrawsALineAcrossTheShortestDistance) {
  std::vector<Vector2d> obstacles_m = {{1.0, 0.0}};
  const SafePolygonOptions options;
  const auto polygon = SafePolygon(obstacles_m, options);
  EXPECT_TRUE(polygon.Contains({1.0 - options.clearance_m - 0.001, 2.0}));
  EXPECT_FALSE(polygon.Contains({1.0 - options.clearance_m + 0.001, -2.0}));
  EXPECT_TRUE(polygon.Contains({-2.9, 0.0}));
}

TEST(SafePolygonTest, AWallIsOneObstacle) {
  std::vector<Vector2d> wall_m;
  for (int i = -40; i <= 40; ++i) wall_m.emplace_back(i % 2 == 0 ? 1.0 : 1.02, 0.05 * i);
  const auto polygon = SafePolygon(wall_m, {});
  EXPECT_EQ(polygon.vertices().size(), 4u);
}

TEST(SafePolygonTest, AnObstacleNearerThanTheClearanceLeavesOnlyWaysOut) {
  std::vector<Vector2d> obstacles_m = {{0.30, 0.0}};
  const auto polygon = SafePolygon(obstacles_m, {});
  EXPECT_TRUE(polygon.Contains({0.0, 0.0}));
  EXPECT_FALSE(polygon.Contains({0.01, 0.0}));
  EXPECT_TRUE(polygon.Contains({-1.0, 0.0}));
}

TEST(SafePolygonTest, AlwaysConvexAroundTheRobotAndClearOfEveryObstacle) {
  const SafePolygonOptions options;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> bearing_rad(-3.2, 3.2);
  std::uniform_real_distribution<double> distance_m(0.2, 5.0);
  std::uniform_int_distribution<int> count(0, 300);
  for (int round = 0; round < 500; ++round) {
    std::vector<Vector2d> obstacles_m(static_cast<size_t>(count(random)));
    for (Vector2d& p_m : obstacles_m) {
      const double b_rad = bearing_rad(random);
      p_m = distance_m(random) * Vector2d(std::cos(b_rad), std::sin(b_rad));
    }
    const std::vector<Vector2d> all_m = obstacles_m;
    const auto polygon = SafePolygon(obstacles_m, options);
    ASSERT_FALSE(polygon.empty());
    EXPECT_TRUE(polygon.Contains(Vector2d::Zero(), 1e-6));

    const auto v = polygon.vertices();
    for (size_t i = 0; i < v.size(); ++i) {
      const Vector2d a_m = v[(i + 1) % v.size()] - v[i];
      const Vector2d b_m = v[(i + 2) % v.size()] - v[(i + 1) % v.size()];
      EXPECT_GE(a_m.x() * b_m.y() - a_m.y() * b_m.x(), -1e-9);
    }
    double kept_m = options.clearance_m;
    for (const Vector2d& p_m : all_m) kept_m = std::min(kept_m, p_m.norm());
    for (const Vector2d& p_m : all_m) {
      const double free_m = kept_m - options.slack_m;
      EXPECT_GE(DistanceToPolygon(polygon, p_m), free_m - 1e-6);
      EXPECT_FALSE(polygon.Contains(p_m));
    }
  }
}

TEST(SafePolygonTest, AsManyDirectionsAsThereCanBeStillFit) {
  std::vector<Vector2d> ring_m;
  for (int i = 0; i < 3600; ++i) {
    const double b_rad = 2.0 * M_PI * i / 3600.0;
    ring_m.emplace_back(4.5 * std::cos(b_rad), 4.5 * std::sin(b_rad));
  }
  EXPECT_NO_THROW(SafePolygon(ring_m, {}));
}

TEST(SafePolygonTest, RefusesOptionsThatNeedMoreLinesThanFit) {
  SafePolygonOptions options;
  options.slack_m = 0.001;
  std::string error;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_THAT(error, testing::HasSubstr("slack_m"));
  EXPECT_THROW(SafePolygon({}, options), ContractViolation);
}

}  // namespace
}  // namespace geon::navigation
