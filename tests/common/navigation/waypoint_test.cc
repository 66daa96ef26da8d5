#include "navigation/waypoint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "navigation/safe_polygon.h"
#include "tests/common/navigation/map_world.h"

namespace geon::navigation {
namespace {

using Eigen::Vector2d;

TEST(WaypointTest, ReachablePlaceBeforeTheTargetIsApproachedStraight) {
  const auto polygon = geometry::ConvexPolygon::Box(2.0, 2.0);
  const Vector2d waypoint_m = WaypointToTarget(polygon, {0.0, 2.5}, 0.9);
  EXPECT_NEAR(waypoint_m.x(), 0.0, 1e-12);
  EXPECT_NEAR(waypoint_m.y(), 1.6, 1e-12);
}

TEST(WaypointTest, OtherwiseTheVertexNearestToTheTargetIsChosen) {
  std::vector<Vector2d> box_m = {{1.0, 0.0}};
  const auto polygon = SafePolygon(box_m, {});
  const Vector2d waypoint_m = WaypointToTarget(polygon, {2.5, 0.5}, 0.9);
  EXPECT_NEAR(waypoint_m.x(), 1.0 - SafePolygonOptions().clearance_m, 1e-9);
  EXPECT_NEAR(waypoint_m.y(), 3.0, 1e-9);
}

TEST(WaypointTest, WithinTheStoppingDistanceTheRobotStays) {
  const auto polygon = geometry::ConvexPolygon::Box(2.0, 2.0);
  EXPECT_TRUE(WaypointToTarget(polygon, {0.5, 0.5}, 0.9).isZero());
}

TEST(WanderTest, SameSeedSameWalkAndNeverANearVertex) {
  std::vector<Vector2d> wall_m = {{0.4, 0.0}};
  const auto polygon = SafePolygon(wall_m, {});
  std::mt19937 first(3);
  std::mt19937 second(3);
  bool differs = false;
  Vector2d last_m = Vector2d::Zero();
  for (int i = 0; i < 20; ++i) {
    const auto waypoint_m = WanderWaypoint(polygon, 0.6, first);
    ASSERT_TRUE(waypoint_m.has_value());
    EXPECT_GE(waypoint_m->norm(), 0.6);
    EXPECT_EQ(*waypoint_m, *WanderWaypoint(polygon, 0.6, second));
    differs = differs || (i > 0 && *waypoint_m != last_m);
    last_m = *waypoint_m;
  }
  EXPECT_TRUE(differs);
}

TEST(WanderTest, EnclosedRobotHasNowhereToGo) {
  std::mt19937 random(1);
  EXPECT_FALSE(WanderWaypoint(geometry::ConvexPolygon::Box(0.1, 0.1), 0.6, random).has_value());
}

// A static world, all of it known, and the cheapest ways to one place.
struct KnownWorld {
  KnownWorld(const std::vector<Vector2d>& obstacles_W_m, const Vector2d& goal_W_m) {
    SeeAllFloor(kHalf_m, &grid);
    Put(obstacles_W_m, &grid);
    clearance.Compute(grid, WindowAround(kHalf_m, grid));
    cost.Compute(grid, clearance, std::vector<CostToGo::Goal>{{grid.CellAt(goal_W_m), 0.0}});
  }
  std::vector<Vector2d> ObstaclesIn(const geometry::RigidTransform& X_WR) const {
    std::vector<Vector2d> points_m;
    grid.ObstaclesNear(X_WR.translation().head<2>(), 5.0, &points_m);
    const geometry::RigidTransform X_RW = X_WR.inverse();
    for (Vector2d& p_m : points_m) p_m = geometry::OnGround(X_RW, p_m);
    return points_m;
  }
  geometry::ConvexPolygon PolygonAt(const geometry::RigidTransform& X_WR) const {
    std::vector<Vector2d> obstacles_R_m = ObstaclesIn(X_WR);
    return SafePolygon(obstacles_R_m, {});
  }

  static constexpr double kHalf_m = 3.0;
  OccupancyGrid grid{OccupancyGridOptions()};
  ClearanceField clearance;
  CostToGo cost{CostToGoOptions()};
};

TEST(WaypointByCostTest, OnFreeFloorTheGoalIsTheWaypoint) {
  const KnownWorld world({}, {1.525, 0.525});
  const auto X_WR = geometry::PlanarPose(-0.5, 0.2, 1.0);
  const auto waypoint_R_m = WaypointByCost(world.PolygonAt(X_WR), X_WR, world.grid, world.cost);
  ASSERT_TRUE(waypoint_R_m.has_value());
  EXPECT_LT((geometry::OnGround(X_WR, *waypoint_R_m) - Vector2d(1.525, 0.525)).norm(), 1e-6);
}

TEST(WaypointByCostTest, LiesInThePolygonAndCostsLess) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> coordinate_m(-2.5, 2.5);
  std::uniform_real_distribution<double> heading_rad(-M_PI, M_PI);
  int answers = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<Vector2d> obstacles_W_m(random() % 25);
    for (Vector2d& p_m : obstacles_W_m) p_m = {coordinate_m(random), coordinate_m(random)};
    const KnownWorld world(obstacles_W_m, {coordinate_m(random), coordinate_m(random)});
    for (int i = 0; i < 40; ++i) {
      const auto X_WR =
          geometry::PlanarPose(coordinate_m(random), coordinate_m(random), heading_rad(random));
      const auto polygon = world.PolygonAt(X_WR);
      const auto waypoint_R_m = WaypointByCost(polygon, X_WR, world.grid, world.cost);
      if (!waypoint_R_m) continue;
      ++answers;
      EXPECT_TRUE(polygon.Contains(*waypoint_R_m, 1e-6)) << "round " << round;
      EXPECT_LT(world.cost.At(world.grid.CellAt(geometry::OnGround(X_WR, *waypoint_R_m))),
                world.cost.At(world.grid.CellAt(X_WR.translation().head<2>())));
    }
  }
  EXPECT_GT(answers, 500);
}

// In a U, with the goal behind its closed side: moving to the nearest vertex is trapped here.
TEST(WaypointByCostTest, LeadsOutOfAUAndAroundIt) {
  std::vector<Vector2d> u_m = Wall({-0.9, 0.8}, {0.8, 0.8});
  Append(Wall({0.8, 0.8}, {0.8, -0.8}), &u_m);
  Append(Wall({0.8, -0.8}, {-0.9, -0.8}), &u_m);
  const KnownWorld world(u_m, {1.825, 0.025});
  const SafePolygonOptions options;
  std::mt19937 random(23);
  std::uniform_real_distribution<double> x_m(-1.5, 0.4);
  std::uniform_real_distribution<double> y_m(-0.4, 0.4);
  std::uniform_real_distribution<double> step_m(0.05, 3.0);
  for (int round = 0; round < 200; ++round) {
    Vector2d p_W_m(x_m(random), y_m(random));
    const double longest_m = step_m(random);
    double nearest_m = 1e9;
    int moves = 0;
    for (; moves < 400; ++moves) {
      const auto X_WR = geometry::PlanarPose(p_W_m.x(), p_W_m.y(), 0.1 * moves);
      const auto waypoint_R_m = WaypointByCost(world.PolygonAt(X_WR), X_WR, world.grid, world.cost);
      if (!waypoint_R_m) break;
      const double length_m = waypoint_R_m->norm();
      p_W_m = geometry::OnGround(X_WR, *waypoint_R_m * std::min(1.0, longest_m / length_m));
      for (const Vector2d& o_m : world.ObstaclesIn(X_WR)) {
        nearest_m = std::min(nearest_m, (geometry::OnGround(X_WR, o_m) - p_W_m).norm());
      }
    }
    EXPECT_LT((p_W_m - Vector2d(1.825, 0.025)).norm(), 0.06) << "round " << round;
    EXPECT_LT(moves, 400) << "round " << round;
    EXPECT_GE(nearest_m, options.clearance_m - options.slack_m - 1e-6) << "round " << round;
  }
}

TEST(WaypointByCostTest, BesideAWallTheWayIsFollowedAsFarAsThePolygonReaches) {
  // Just ahead, nearer than the clearance; the goal behind it.
  const KnownWorld world(Wall({0.3, -1.0}, {0.3, 1.5}), {1.525, 0.025});
  const auto X_WR = geometry::PlanarPose(0.0, 0.0, 0.0);
  const auto waypoint_R_m = WaypointByCost(world.PolygonAt(X_WR), X_WR, world.grid, world.cost);
  ASSERT_TRUE(waypoint_R_m.has_value());
  EXPECT_LT(waypoint_R_m->x(), 1e-6);
  EXPECT_LT(waypoint_R_m->y(), -0.2);
}

TEST(WaypointByCostTest, WhereThePolygonEndsAtOnceItsBorderIsFollowed) {
  // Between two posts, nearer than the clearance both: the polygon is a line that misses the
  // middles of all cells.
  const KnownWorld world({{0.0, 0.31}, {0.0, -0.31}}, {1.525, 0.025});
  const auto X_WR = geometry::PlanarPose(0.0, 0.0, 0.0);
  const auto waypoint_R_m = WaypointByCost(world.PolygonAt(X_WR), X_WR, world.grid, world.cost);
  ASSERT_TRUE(waypoint_R_m.has_value());
  EXPECT_NEAR(waypoint_R_m->x(), 1.525, 0.11);
  EXPECT_NEAR(waypoint_R_m->y(), 0.0, 1e-6);
}

TEST(WaypointByCostTest, NothingWhereNothingIsCheaper) {
  const auto X_WR = geometry::PlanarPose(-1.0, 0.0, 0.0);
  const KnownWorld closed(Wall({0.0, -3.0}, {0.0, 3.0}), {1.525, 0.025});
  EXPECT_FALSE(WaypointByCost(closed.PolygonAt(X_WR), X_WR, closed.grid, closed.cost).has_value());
  const KnownWorld there({}, {-1.0, 0.0});
  EXPECT_FALSE(WaypointByCost(there.PolygonAt(X_WR), X_WR, there.grid, there.cost).has_value());
}

}  // namespace
}  // namespace geon::navigation
