#include "navigation/safe_polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>
#include <span>
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

// Convex, counter-clockwise, around the robot.
void ExpectSafeShape(const geometry::ConvexPolygon& polygon) {
  ASSERT_FALSE(polygon.empty());
  EXPECT_TRUE(polygon.Contains(Vector2d::Zero(), 1e-6));
  const auto v = polygon.vertices();
  for (size_t i = 0; i < v.size(); ++i) {
    const Vector2d a_m = v[(i + 1) % v.size()] - v[i];
    const Vector2d b_m = v[(i + 2) % v.size()] - v[(i + 1) % v.size()];
    EXPECT_GE(a_m.x() * b_m.y() - a_m.y() * b_m.x(), -1e-9);
  }
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
    ExpectSafeShape(polygon);
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

// Points anywhere, or along walls, none nearer than `nearest_m`.
void RandomPoints(double nearest_m, std::mt19937* random, std::vector<Vector2d>* points_m) {
  std::uniform_real_distribution<double> bearing_rad(-M_PI, M_PI);
  std::uniform_real_distribution<double> distance_m(nearest_m, 5.0);
  const bool walls = (*random)() % 2 == 0;
  points_m->resize((*random)() % 32);
  Vector2d step_m = Vector2d::Zero();
  for (size_t i = 0; i < points_m->size(); ++i) {
    Vector2d& p_m = (*points_m)[i];
    if (walls && i % 8 != 0) {
      p_m = (*points_m)[i - 1] + step_m;
      if (p_m.norm() >= nearest_m) continue;
    }
    const double at_rad = bearing_rad(*random);
    p_m = distance_m(*random) * Vector2d(std::cos(at_rad), std::sin(at_rad));
    const double along_rad = bearing_rad(*random);
    step_m = 0.1 * Vector2d(std::cos(along_rad), std::sin(along_rad));
  }
}

TEST(SafePolygonTest, KeepsClearOfAHundredThousandSetsOfObstacles) {
  const SafePolygonOptions options;
  std::mt19937 random(41);
  std::vector<Vector2d> obstacles_m;
  for (int round = 0; round < 100'000; ++round) {
    // Every fourth time things may be nearer than the clearance.
    const bool near = round % 4 == 0;
    RandomPoints(near ? 0.05 : options.clearance_m, &random, &obstacles_m);
    std::vector<Vector2d> given_m = obstacles_m;
    const auto polygon = SafePolygon(given_m, options);
    ExpectSafeShape(polygon);
    double nearest_m = options.clearance_m;
    for (const Vector2d& p_m : obstacles_m) nearest_m = std::min(nearest_m, p_m.norm());
    for (const Vector2d& p_m : obstacles_m) {
      EXPECT_FALSE(polygon.Contains(p_m, -1e-9)) << "round " << round;
      if (nearest_m < options.clearance_m) continue;
      EXPECT_GE(DistanceToPolygon(polygon, p_m), options.clearance_m - options.slack_m - 1e-9)
          << "round " << round;
    }
    if (testing::Test::HasFailure()) break;
  }
}

TEST(SafePolygonTest, ObstaclesAreReorderedAndNotLost) {
  const std::vector<Vector2d> obstacles_m = {{2.0, 0.0}, {1.0, 0.0}, {0.0, 1.5}};
  std::vector<Vector2d> given_m = obstacles_m;
  SafePolygon(given_m, {});
  EXPECT_THAT(given_m, testing::UnorderedElementsAreArray(obstacles_m));
}

TEST(SafePolygonTest, ANearObstacleDoesNotBringTheRobotNearToAnother) {
  const SafePolygonOptions options;
  std::vector<Vector2d> obstacles_m = {{0.28, 0.0}, {0.255, 1.0}};
  const auto polygon = SafePolygon(obstacles_m, options);
  EXPECT_GE(DistanceToPolygon(polygon, {0.255, 1.0}), options.clearance_m - options.slack_m - 1e-9);
}

TEST(SafePolygonTest, AnObstacleUnderTheRobotDoesNotHideAnother) {
  std::vector<Vector2d> obstacles_m = {{0.01, 0.0}, {-0.015, 1.0}};
  EXPECT_FALSE(SafePolygon(obstacles_m, {}).Contains({-0.015, 1.0}));
}

// The intersection of half-planes that all hold the origin inside: sorted by angle, then once
// around with a deque (O(n log n)).
std::vector<Vector2d> SortedIntersection(std::vector<geometry::HalfPlane> planes) {
  const auto angle = [](const geometry::HalfPlane& h) {
    return std::atan2(h.normal.y(), h.normal.x());
  };
  std::sort(planes.begin(), planes.end(),
            [&](const auto& a, const auto& b) { return angle(a) < angle(b); });
  const auto crossing = [](const geometry::HalfPlane& a, const geometry::HalfPlane& b) -> Vector2d {
    const double sine = a.normal.x() * b.normal.y() - a.normal.y() * b.normal.x();
    return Vector2d(a.offset_m * b.normal.y() - b.offset_m * a.normal.y(),
                    b.offset_m * a.normal.x() - a.offset_m * b.normal.x()) /
           sine;
  };
  std::deque<geometry::HalfPlane> kept;
  for (const geometry::HalfPlane& plane : planes) {
    while (kept.size() > 1 && plane.Depth(crossing(kept.end()[-2], kept.back())) <= 0.0) {
      kept.pop_back();
    }
    while (kept.size() > 1 && plane.Depth(crossing(kept[0], kept[1])) <= 0.0) kept.pop_front();
    kept.push_back(plane);
  }
  while (kept.size() > 2 && kept[0].Depth(crossing(kept.end()[-2], kept.back())) <= 0.0) {
    kept.pop_back();
  }
  std::vector<Vector2d> vertices_m;
  for (size_t i = 0; i < kept.size(); ++i) {
    vertices_m.push_back(crossing(kept[i], kept[(i + 1) % kept.size()]));
  }
  return vertices_m;
}

double Area(std::span<const Vector2d> v_m) {
  double twice_m2 = 0.0;
  for (size_t i = 0; i < v_m.size(); ++i) {
    const Vector2d& next_m = v_m[(i + 1) % v_m.size()];
    twice_m2 += v_m[i].x() * next_m.y() - v_m[i].y() * next_m.x();
  }
  return 0.5 * twice_m2;
}

TEST(SafePolygonTest, ClippingIsTheIntersectionOfHalfPlanesFoundAnotherWay) {
  constexpr double kHalf_m = 3.0;
  std::mt19937 random(43);
  std::uniform_real_distribution<double> bearing_rad(-M_PI, M_PI);
  std::uniform_real_distribution<double> offset_m(0.01, 4.0);
  std::vector<geometry::HalfPlane> planes;
  for (int round = 0; round < 20'000; ++round) {
    auto polygon = geometry::ConvexPolygon::Box(kHalf_m, kHalf_m);
    planes = {{{1.0, 0.0}, kHalf_m},
              {{0.0, 1.0}, kHalf_m},
              {{-1.0, 0.0}, kHalf_m},
              {{0.0, -1.0}, kHalf_m}};
    for (auto i = random() % 40; i > 0; --i) {
      const double at_rad = bearing_rad(random);
      planes.push_back({{std::cos(at_rad), std::sin(at_rad)}, offset_m(random)});
      polygon.Clip(planes.back());
    }
    const std::vector<Vector2d> expected_m = SortedIntersection(planes);
    ASSERT_NEAR(Area(polygon.vertices()), Area(expected_m), 1e-6) << "round " << round;
    for (const Vector2d& v_m : expected_m) {
      ASSERT_TRUE(polygon.Contains(v_m, 1e-6)) << "round " << round;
    }
    for (const Vector2d& v_m : polygon.vertices()) {
      for (const geometry::HalfPlane& plane : planes) {
        ASSERT_GE(plane.Depth(v_m), -1e-6) << "round " << round;
      }
    }
  }
}

}  // namespace
}  // namespace geon::navigation
