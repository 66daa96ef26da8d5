#include "navigation/clearance_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "base/contracts.h"
#include "tests/common/navigation/map_world.h"

namespace geon::navigation {
namespace {

using Eigen::Vector2d;

// The clearance of a place, asked of every obstacle.
double NearestTo(const Vector2d& p_W_m, const std::vector<Vector2d>& obstacles_W_m) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Vector2d& o_W_m : obstacles_W_m) {
    nearest_m = std::min(nearest_m, (o_W_m - p_W_m).norm());
  }
  return nearest_m;
}

std::vector<Vector2d> AllObstacles(const OccupancyGrid& grid) {
  std::vector<Vector2d> points_W_m;
  grid.ObstaclesNear({0.0, 0.0}, 100.0, &points_W_m);
  return points_W_m;
}

TEST(ClearanceFieldTest, IsTheDistanceToWhereTheObstacleWasMet) {
  OccupancyGrid grid({});
  Put(std::vector<Vector2d>{{0.049, 0.001}}, &grid);
  ClearanceField field;
  field.Compute(grid, WindowAround(1.0, grid));
  EXPECT_NEAR(field.At({10, 0}), std::hypot(0.525 - 0.049, 0.024), 1e-5);
  EXPECT_NEAR(field.At({0, 0}), std::hypot(0.024, 0.024), 1e-5);
}

TEST(ClearanceFieldTest, EqualsTheNearestOfAllObstacles) {
  constexpr double kHalf_m = 2.0;
  std::mt19937 random(21);
  std::uniform_real_distribution<double> coordinate_m(-kHalf_m, kHalf_m);
  for (int round = 0; round < 60; ++round) {
    OccupancyGrid grid({});
    std::vector<Vector2d> points_m(1 + random() % (round % 2 == 0 ? 8 : 200));
    for (Vector2d& p_m : points_m) p_m = {coordinate_m(random), coordinate_m(random)};
    if (round % 3 == 0) {
      Append(Wall(points_m[0], {coordinate_m(random), coordinate_m(random)}), &points_m);
    }
    Put(points_m, &grid);
    const std::vector<Vector2d> obstacles_W_m = AllObstacles(grid);
    ClearanceField field;
    field.Compute(grid, WindowAround(kHalf_m, grid));
    double worst_m = 0.0;
    ForEachCell(field.window(), [&](GridCell cell) {
      const double off_m = field.At(cell) - NearestTo(grid.Middle(cell), obstacles_W_m);
      EXPECT_GE(off_m, -1e-5) << "round " << round;
      worst_m = std::max(worst_m, off_m);
    });
    EXPECT_LE(worst_m, 0.3 * grid.cell_m()) << "round " << round;
  }
}

TEST(ClearanceFieldTest, IgnoredObstaclesDoNotCount) {
  OccupancyGrid grid({});
  Put(std::vector<Vector2d>{{0.51, 0.0}, {-0.99, 0.0}}, &grid);
  ClearanceField field;
  field.Compute(grid, WindowAround(2.0, grid), [](const Vector2d& p_m) { return p_m.x() > 0.0; });
  EXPECT_NEAR(field.At({0, 0}), std::hypot(0.99 + 0.025, 0.025), 1e-5);
  field.Compute(grid, WindowAround(2.0, grid), [](const Vector2d&) { return true; });
  EXPECT_TRUE(std::isinf(field.At({0, 0})));
}

TEST(ClearanceFieldTest, IsInfiniteWithoutObstacles) {
  OccupancyGrid grid({});
  ClearanceField field;
  field.Compute(grid, WindowAround(1.0, grid));
  EXPECT_EQ(field.window().size(), 1600u);
  ForEachCell(field.window(), [&](GridCell cell) { EXPECT_TRUE(std::isinf(field.At(cell))); });
}

TEST(ClearanceFieldTest, ASecondComputationKnowsNothingOfTheFirst) {
  OccupancyGrid grid({});
  Put(std::vector<Vector2d>{{0.0, 0.0}}, &grid);
  ClearanceField field;
  field.Compute(grid, WindowAround(1.0, grid));
  grid.Clear();
  const GridWindow window{{3, -2}, {9, 1}};
  field.Compute(grid, window);
  EXPECT_EQ(field.window().size(), 28u);
  EXPECT_TRUE(field.window().Contains({9, 1}));
  EXPECT_FALSE(field.window().Contains({10, 1}));
  EXPECT_FALSE(field.window().Contains({3, -3}));
  ForEachCell(window, [&](GridCell cell) { EXPECT_TRUE(std::isinf(field.At(cell))); });
}

TEST(ClearanceFieldTest, RefusesAnEmptyWindow) {
  const OccupancyGrid grid({});
  ClearanceField field;
  EXPECT_THROW(field.Compute(grid, {{0, 0}, {-1, 4}}), ContractViolation);
}

}  // namespace
}  // namespace geon::navigation
