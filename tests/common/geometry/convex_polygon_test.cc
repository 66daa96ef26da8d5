#include "geometry/convex_polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/contracts.h"

namespace geon::geometry {
namespace {

TEST(ConvexPolygonTest, ClipCutsACornerOff) {
  ConvexPolygon polygon = ConvexPolygon::Box(1.0, 1.0);
  polygon.Clip({Eigen::Vector2d(1, 1).normalized(), std::sqrt(0.5)});  // x + y <= 1
  ASSERT_EQ(polygon.vertices().size(), 5u);
  EXPECT_TRUE(polygon.Contains({0.99, 0.0}));
  EXPECT_FALSE(polygon.Contains({0.9, 0.9}));
}

TEST(ConvexPolygonTest, ClippingEverythingAwayLeavesNothing) {
  ConvexPolygon polygon = ConvexPolygon::Box(1.0, 1.0);
  polygon.Clip({Eigen::Vector2d::UnitX(), -2.0});
  EXPECT_TRUE(polygon.empty());
  EXPECT_FALSE(polygon.Contains({0.0, 0.0}));
}

TEST(ConvexPolygonTest, OpposedLinesLeaveASegmentThatStillContainsItsPoints) {
  ConvexPolygon polygon = ConvexPolygon::Box(1.0, 1.0);
  polygon.Clip({Eigen::Vector2d::UnitX(), 0.0});
  polygon.Clip({-Eigen::Vector2d::UnitX(), 0.0});
  EXPECT_TRUE(polygon.Contains({0.0, 0.5}));
  EXPECT_FALSE(polygon.Contains({0.01, 0.5}));
  polygon.Clip({Eigen::Vector2d::UnitY(), 0.0});
  polygon.Clip({-Eigen::Vector2d::UnitY(), 0.0});
  EXPECT_TRUE(polygon.Contains({0.0, 0.0}));
  EXPECT_FALSE(polygon.Contains({0.0, 0.5}));
}

TEST(ConvexPolygonTest, ClippedPointsAreExactlyThoseOutside) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (int round = 0; round < 200; ++round) {
    std::vector<HalfPlane> planes;
    ConvexPolygon polygon = ConvexPolygon::Box(1.0, 1.0);
    for (int i = 0; i < 12; ++i) {
      const double angle_rad = 4.0 * coordinate(random);
      planes.push_back({{std::cos(angle_rad), std::sin(angle_rad)}, 0.3 * coordinate(random)});
      polygon.Clip(planes.back());
    }
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector2d p_m(coordinate(random), coordinate(random));
      double depth_m = std::min(1.0 - std::abs(p_m.x()), 1.0 - std::abs(p_m.y()));
      for (const HalfPlane& plane : planes) depth_m = std::min(depth_m, plane.Depth(p_m));
      if (std::abs(depth_m) < 1e-6) continue;
      EXPECT_EQ(polygon.Contains(p_m), depth_m > 0.0) << "round " << round;
    }
  }
}

TEST(ConvexPolygonTest, RefusesABoxWithoutArea) {
  EXPECT_THROW(ConvexPolygon::Box(0.0, 1.0), ContractViolation);
}

}  // namespace
}  // namespace geon::geometry
