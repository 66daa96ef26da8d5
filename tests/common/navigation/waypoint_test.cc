#include "navigation/waypoint.h"

#include <gtest/gtest.h>

#include "navigation/safe_polygon.h"

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

}  // namespace
}  // namespace geon::navigation
