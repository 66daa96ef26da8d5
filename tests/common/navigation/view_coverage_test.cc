#include "navigation/view_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "base/angles.h"
#include "base/contracts.h"
#include "tests/common/navigation/map_world.h"

namespace geon::navigation {
namespace {

using Eigen::Vector2d;

constexpr size_t kDesk = 2;  // of ViewCoverage({0.0, 0.7})
constexpr double kLookFar_m = 5.0;
const geometry::PinholeCamera kLookCamera{160, 120, 120.0, 120.0, 79.5, 59.5};

Vector2d Along(double bearing_rad) { return {std::cos(bearing_rad), std::sin(bearing_rad)}; }

// Of a camera as high as the head's, looking down by this much.
geometry::RigidTransform LookPose(double x_m, double y_m, double heading_rad,
                                  double down_rad = 0.35) {
  return geometry::PlanarPose(x_m, y_m, heading_rad) *
         geometry::MakeTransform(geometry::RotationAboutY(down_rad) * geometry::CameraAxesInBody(),
                                 Eigen::Vector3d(0.0, 0.0, 1.3));
}

class ViewCoverageTest : public testing::Test {
 protected:
  void Look(const geometry::RigidTransform& X_WC) {
    coverage_.Look(kLookCamera, X_WC, kLookFar_m, map_);
  }
  bool Floor(const Vector2d& p_m) const { return coverage_.IsLooked(ViewCoverage::kFloor, p_m); }
  bool Over(const Vector2d& p_m) const {
    return coverage_.IsLooked(ViewCoverage::kFloorOverObstacles, p_m);
  }
  OccupancyGrid map_{OccupancyGridOptions()};
  ViewCoverage coverage_{{0.0, 0.7}};
};

TEST(FreeSightTest, EndsWithinACellOfTheFirstObstacle) {
  OccupancyGrid map{OccupancyGridOptions()};
  Put(Wall({2.0, -1.0}, {2.0, 1.0}), &map);
  Put(Wall({3.0, -1.0}, {3.0, 1.0}), &map);
  for (const double bearing_rad : {0.0, 0.3, -0.4}) {
    const double wall_m = 2.0 / std::cos(bearing_rad);
    const double sight_m = FreeSight(map, {0.0, 0.0}, Along(bearing_rad), 5.0);
    EXPECT_LE(sight_m, wall_m + map.cell_m());
    EXPECT_GE(sight_m, wall_m - 3.0 * map.cell_m());
  }
  EXPECT_EQ(FreeSight(map, {0.0, 0.0}, Along(kPi), 5.0), 5.0);
  EXPECT_EQ(FreeSight(map, {0.0, 0.0}, Along(0.0), 1.5), 1.5) << "nobody looks so far";
}

TEST(FreeSightTest, NoWallIsLookedThroughAtAnySlant) {
  OccupancyGrid map{OccupancyGridOptions()};
  const std::vector<Vector2d> corners_m = {{1.3, 0.4}, {-0.7, 1.6}, {-1.5, -0.9}, {0.8, -1.1}};
  Put(ClosedWall(corners_m), &map);
  for (int k = 0; k < 720; ++k) {
    const Vector2d from_m(0.02 * (k % 7), -0.01 * (k % 11));
    EXPECT_LT(FreeSight(map, from_m, Along(2.0 * kPi * k / 720), 5.0), 2.1) << k;
  }
}

TEST(FreeSightTest, TheRobotIsNotInItsOwnWay) {
  OccupancyGrid map{OccupancyGridOptions()};
  Put(std::vector<Vector2d>{{0.05, 0.0}}, &map);
  EXPECT_EQ(FreeSight(map, {0.0, 0.0}, Along(0.0), 3.0), 3.0);
}

TEST_F(ViewCoverageTest, HasThePlanesOfTheFloorTwiceAndOfEveryDesk) {
  const auto& planes = coverage_.planes();
  ASSERT_EQ(planes.size(), 3U) << "the floor among the supports is the floor";
  EXPECT_EQ(planes[ViewCoverage::kFloor].height_m, 0.0);
  EXPECT_FALSE(planes[ViewCoverage::kFloor].over_obstacles);
  EXPECT_EQ(planes[ViewCoverage::kFloorOverObstacles].height_m, 0.0);
  EXPECT_TRUE(planes[ViewCoverage::kFloorOverObstacles].over_obstacles);
  EXPECT_EQ(planes[kDesk].height_m, 0.7);
  EXPECT_TRUE(planes[kDesk].over_obstacles);
}

TEST_F(ViewCoverageTest, RefusesMoreHeightsThanItKeepsAndAReachWithoutCells) {
  EXPECT_NO_THROW(ViewCoverage({0.1, 0.2, 0.3, 0.4, 0.5, 0.6}));
  EXPECT_THROW(ViewCoverage({0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}), ContractViolation);
  EXPECT_THROW(ViewCoverage({}, 0.05), ContractViolation);
}

TEST_F(ViewCoverageTest, WithoutObstaclesItIsWhatThePictureShows) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> turn_rad(-kPi, kPi), tilt_rad(0.1, 0.7), place_m(-1, 1);
  constexpr double kCell_m = ViewCoverage::kCell_m;
  size_t inside = 0, outside = 0;
  for (int i = 0; i < 12; ++i) {
    coverage_.Clear();
    const auto X_WC =
        LookPose(place_m(random), place_m(random), turn_rad(random), tilt_rad(random));
    const Vector2d from_m = X_WC.translation().head<2>();
    Look(X_WC);
    for (size_t plane = 0; plane < coverage_.planes().size(); ++plane) {
      const double z_m = coverage_.planes()[plane].height_m + ViewCoverage::kMiddle_m;
      ForEachCell({{-60, -60}, {59, 59}}, [&](GridCell cell) {
        Vector2d low_px(1e9, 1e9), high_px(-1e9, -1e9);
        int in_front = 0;
        double nearest_m = 1e9, farthest_m = 0.0;
        for (int corner = 0; corner < 4; ++corner) {
          const Vector2d p_m(kCell_m * (cell.x + corner % 2), kCell_m * (cell.y + corner / 2));
          const Eigen::Vector3d p_C_m = X_WC.inverse() * Eigen::Vector3d(p_m.x(), p_m.y(), z_m);
          in_front += p_C_m.z() > 0.1;
          const Vector2d pixel_px = kLookCamera.Project(p_C_m);
          low_px = low_px.cwiseMin(pixel_px);
          high_px = high_px.cwiseMax(pixel_px);
          nearest_m = std::min(nearest_m, (p_m - from_m).norm());
          farthest_m = std::max(farthest_m, (p_m - from_m).norm());
        }
        if (in_front > 0 && in_front < 4) return;
        const Vector2d middle_m(kCell_m * (cell.x + 0.5), kCell_m * (cell.y + 0.5));
        const bool shown = in_front == 4 && low_px.minCoeff() > 8.0 && high_px.x() < 151.0 &&
                           high_px.y() < 111.0 && farthest_m < kLookFar_m - kCell_m;
        const bool hidden = in_front == 0 || high_px.x() < 0.0 || high_px.y() < 0.0 ||
                            low_px.x() > 159.0 || low_px.y() > 119.0 ||
                            nearest_m > kLookFar_m + kCell_m;
        if (!shown && !hidden) return;
        EXPECT_EQ(coverage_.IsLooked(plane, middle_m), shown)
            << "plane " << plane << ": " << middle_m.transpose();
        inside += shown;
        outside += hidden;
      });
    }
  }
  EXPECT_GT(inside, 1000U);
  EXPECT_GT(outside, 100000U);
}

TEST_F(ViewCoverageTest, AWallHidesTheFloorBehindItButIsLookedOver) {
  Put(Wall({2.0, -2.0}, {2.0, 2.0}), &map_);
  Look(LookPose(0.0, 0.0, 0.0));
  EXPECT_TRUE(Floor({1.8, 0.0}));
  EXPECT_TRUE(Over({1.8, 0.0}));
  for (const double x_m : {2.15, 2.5, 3.5}) {
    EXPECT_FALSE(Floor({x_m, 0.0})) << x_m;
    EXPECT_TRUE(Over({x_m, 0.0})) << x_m;
  }
  EXPECT_TRUE(coverage_.IsLooked(kDesk, {2.15, 0.0})) << "a desk's top is seen over its front";
}

TEST_F(ViewCoverageTest, LooksAddUpUntilItIsCleared) {
  Look(LookPose(0.0, 0.0, 0.0));
  Look(LookPose(0.0, 0.0, 2.0));
  const Vector2d first_m = 3.0 * Along(0.0), second_m = 3.0 * Along(2.0);
  EXPECT_TRUE(Floor(first_m));
  EXPECT_TRUE(Floor(second_m));
  EXPECT_FALSE(Floor(3.0 * Along(-2.0)));
  coverage_.Clear();
  EXPECT_FALSE(Floor(first_m));
  EXPECT_FALSE(Floor(second_m));
}

TEST_F(ViewCoverageTest, AMarkIsOfOneCellOfOnePlane) {
  coverage_.Mark(ViewCoverage::kFloor, {-1.23, 0.77});
  EXPECT_TRUE(Floor({-1.21, 0.71}));
  EXPECT_FALSE(Floor({-1.31, 0.77}));
  EXPECT_FALSE(Floor({-1.23, 0.81}));
  EXPECT_FALSE(Over({-1.23, 0.77}));
  EXPECT_FALSE(coverage_.IsLooked(kDesk, {-1.23, 0.77}));
}

TEST_F(ViewCoverageTest, OffTheMapEverythingIsLookedAtAndNothingIsKept) {
  ViewCoverage small({}, 2.0);
  EXPECT_FALSE(small.IsLooked(ViewCoverage::kFloor, {1.99, -1.99}));
  for (const Vector2d& p_m : {Vector2d(2.01, 0.0), Vector2d(0.0, -2.01), Vector2d(50.0, 50.0)}) {
    EXPECT_TRUE(small.IsLooked(ViewCoverage::kFloor, p_m)) << p_m.transpose();
    EXPECT_NO_THROW(small.Mark(ViewCoverage::kFloor, p_m));
  }
  small.Look(kLookCamera, LookPose(0.0, 0.0, 0.0), kLookFar_m, map_);
  EXPECT_TRUE(small.IsLooked(ViewCoverage::kFloor, {1.9, 0.0}));
  EXPECT_FALSE(small.IsLooked(ViewCoverage::kFloor, {-1.9, 0.0}));
}

}  // namespace
}  // namespace geon::navigation
