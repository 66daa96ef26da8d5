#include "navigation/safe_polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
void RandomPoints(double nearest_m, size_t count, std::mt19937* random,
                  std::vector<Vector2d>* points_m) {
  std::uniform_real_distribution<double> bearing_rad(-M_PI, M_PI);
  std::uniform_real_distribution<double> distance_m(nearest_m, 5.0);
  const bool walls = (*random)() % 2 == 0;
  points_m->resize(count);
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

// The lines by the rule in safe_polygon.h's words: every point is asked of every obstacle so far.
std::vector<geometry::HalfPlane> LinesByTheRule(std::vector<Vector2d> points_m,
                                                const SafePolygonOptions& options) {
  const double reach_m = std::hypot(options.default_box_m, options.default_box_m);
  std::sort(points_m.begin(), points_m.end(),
            [](const auto& a_m, const auto& b_m) { return a_m.norm() < b_m.norm(); });
  std::vector<geometry::HalfPlane> lines;
  for (const Vector2d& p_m : points_m) {
    const double distance_m = p_m.norm();
    if (distance_m >= reach_m + options.clearance_m) break;
    const auto has = [&](const geometry::HalfPlane& line) {
      const double ahead_m = line.normal.dot(p_m);
      return ahead_m > line.offset_m + options.clearance_m - options.slack_m ||
             ahead_m > distance_m * (1.0 - options.slack_m / (reach_m + options.clearance_m));
    };
    if (std::any_of(lines.begin(), lines.end(), has)) continue;
    lines.push_back({p_m / distance_m, std::max(0.0, distance_m - options.clearance_m)});
  }
  for (const Vector2d& side : {Vector2d(1, 0), Vector2d(0, 1), Vector2d(-1, 0), Vector2d(0, -1)}) {
    lines.push_back({side, options.default_box_m});
  }
  return lines;
}

// The corners of an intersection of half-planes, from the convex hull of the points that are dual
// to them (Andrew's monotone chain, O(n log n)). A line through the origin, which has no dual, is
// put a little before it.
std::vector<Vector2d> CornersByDuality(std::span<const geometry::HalfPlane> lines) {
  std::vector<Vector2d> dual_1_m;
  for (const geometry::HalfPlane& line : lines) {
    dual_1_m.push_back(line.normal / std::max(1e-6, line.offset_m));
  }
  std::sort(dual_1_m.begin(), dual_1_m.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  const auto cross = [](const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  std::vector<Vector2d> hull;
  const auto chain = [&](auto begin, auto end) {
    const size_t first = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() > first + 1 &&
             cross(hull.back() - hull.end()[-2], *p - hull.end()[-2]) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  chain(dual_1_m.begin(), dual_1_m.end());
  chain(dual_1_m.rbegin(), dual_1_m.rend());
  std::vector<Vector2d> corners_m;
  for (size_t i = 0; i < hull.size(); ++i) {
    // Where p . a = p . b = 1.
    const Vector2d& a = hull[i];
    const Vector2d& b = hull[(i + 1) % hull.size()];
    corners_m.emplace_back(Vector2d(b.y() - a.y(), a.x() - b.x()) / cross(a, b));
  }
  return corners_m;
}

TEST(SafePolygonTest, AHundredThousandSetsGiveWhatTheRuleGivesBySortingAndDuality) {
  const SafePolygonOptions options;
  std::mt19937 random(43);
  std::vector<Vector2d> obstacles_m;
  for (int round = 0; round < 100'000 && !testing::Test::HasFailure(); ++round) {
    // Now and then more than can be sorted at once, or nearer than the clearance.
    const size_t count = random() % (round % 16 == 0 ? 300 : 40);
    RandomPoints(round % 4 == 0 ? 0.05 : options.clearance_m, count, &random, &obstacles_m);
    const auto lines = LinesByTheRule(obstacles_m, options);
    const auto polygon = SafePolygon(obstacles_m, options);
    for (const Vector2d& corner_m : CornersByDuality(lines)) {
      EXPECT_TRUE(polygon.Contains(corner_m, 1e-6)) << "round " << round;
    }
    for (const Vector2d& corner_m : polygon.vertices()) {
      for (const auto& line : lines) EXPECT_GE(line.Depth(corner_m), -2e-6) << "round " << round;
    }
  }
}

TEST(SafePolygonTest, KeepsClearOfAHundredThousandSetsOfObstacles) {
  const SafePolygonOptions options;
  std::mt19937 random(41);
  std::vector<Vector2d> obstacles_m;
  for (int round = 0; round < 100'000 && !testing::Test::HasFailure(); ++round) {
    // Every fourth time things may be nearer than the clearance.
    const bool near = round % 4 == 0;
    RandomPoints(near ? 0.05 : options.clearance_m, random() % 32, &random, &obstacles_m);
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

}  // namespace
}  // namespace geon::navigation
