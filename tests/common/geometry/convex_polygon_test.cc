#include "geometry/convex_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::geometry {
namespace {

HalfPlane Towards(double bearing_rad, double offset_m) {
  return {{std::cos(bearing_rad), std::sin(bearing_rad)}, offset_m};
}

// The sides of a box of half a side 1 m, in order, with these lines among them.
std::vector<HalfPlane> BoxAnd(const std::vector<HalfPlane>& lines) {
  std::vector<HalfPlane> all = {{Eigen::Vector2d::UnitX(), 1.0},
                                {Eigen::Vector2d::UnitY(), 1.0},
                                {-Eigen::Vector2d::UnitX(), 1.0},
                                {-Eigen::Vector2d::UnitY(), 1.0}};
  all.insert(all.end(), lines.begin(), lines.end());
  std::stable_sort(all.begin(), all.end(), [](const HalfPlane& a, const HalfPlane& b) {
    return std::atan2(a.normal.y(), a.normal.x()) < std::atan2(b.normal.y(), b.normal.x());
  });
  return all;
}

TEST(ConvexPolygonTest, ALineCutsACornerOff) {
  const auto polygon = ConvexPolygon::Intersection(BoxAnd({Towards(kPi / 4, std::sqrt(0.5))}));
  ASSERT_EQ(polygon.vertices().size(), 5u);
  EXPECT_TRUE(polygon.Contains({0.99, 0.0}));
  EXPECT_FALSE(polygon.Contains({0.9, 0.9}));
}

TEST(ConvexPolygonTest, ALineBeyondACornerAddsNothing) {
  EXPECT_EQ(ConvexPolygon::Intersection(BoxAnd({Towards(0.7, 1.5)})).vertices().size(), 4u);
}

TEST(ConvexPolygonTest, OfParallelLinesTheNearestHolds) {
  for (const double offset_m : {0.5, 1.0, 2.0}) {
    for (const double bearing_rad : {0.0, 0.5 * kPi, kPi, -0.5 * kPi, 1e-12, -1e-12}) {
      const auto polygon = ConvexPolygon::Intersection(BoxAnd({Towards(bearing_rad, offset_m)}));
      EXPECT_EQ(polygon.vertices().size(), 4u);
      const double side_m = std::min(1.0, offset_m);
      const Eigen::Vector2d ahead(std::cos(bearing_rad), std::sin(bearing_rad));
      EXPECT_TRUE(polygon.Contains((side_m - 1e-6) * ahead));
      EXPECT_FALSE(polygon.Contains((side_m + 1e-6) * ahead));
    }
  }
}

TEST(ConvexPolygonTest, OpposedLinesThatNearlyTouchLeaveAStrip) {
  const auto polygon =
      ConvexPolygon::Intersection(BoxAnd({Towards(0.0, 1e-4), Towards(kPi, 1e-4)}));
  EXPECT_TRUE(polygon.Contains({0.0, 0.999}));
  EXPECT_FALSE(polygon.Contains({0.0002, 0.5}));
}

TEST(ConvexPolygonTest, TheIntersectionIsWhatNoLineCutsOff) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> bearing_rad(-kPi, kPi);
  std::uniform_real_distribution<double> coordinate_m(-1.5, 1.5);
  std::uniform_real_distribution<double> power(-3.0, 0.3);
  for (int round = 0; round < 5'000; ++round) {
    std::vector<HalfPlane> lines(random() % 30);
    for (HalfPlane& line : lines) {
      line = Towards(bearing_rad(random), std::pow(10.0, power(random)));
    }
    const std::vector<HalfPlane> all = BoxAnd(lines);
    const auto polygon = ConvexPolygon::Intersection(all);
    for (const Eigen::Vector2d& v_m : polygon.vertices()) {
      int sides = 0;
      for (const HalfPlane& line : all) {
        EXPECT_GE(line.Depth(v_m), -1e-8) << "round " << round;
        if (std::abs(line.Depth(v_m)) < 1e-8) ++sides;
      }
      EXPECT_GE(sides, 2) << "round " << round;
    }
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector2d p_m = std::pow(10.0, power(random)) *
                                  Eigen::Vector2d(coordinate_m(random), coordinate_m(random));
      double depth_m = 1.0;
      for (const HalfPlane& line : all) depth_m = std::min(depth_m, line.Depth(p_m));
      if (std::abs(depth_m) < 1e-8) continue;
      EXPECT_EQ(polygon.Contains(p_m), depth_m > 0.0) << "round " << round;
    }
  }
}

TEST(ConvexPolygonTest, RefusesLinesThatLeaveTheOriginOut) {
  EXPECT_THROW(ConvexPolygon::Intersection(BoxAnd({Towards(1.0, 0.0)})), ContractViolation);
  EXPECT_THROW(ConvexPolygon::Intersection({}), ContractViolation);
}

TEST(ConvexPolygonTest, RefusesABoxWithoutArea) {
  EXPECT_THROW(ConvexPolygon::Box(0.0, 1.0), ContractViolation);
}

}  // namespace
}  // namespace geon::geometry
