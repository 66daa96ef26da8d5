#include "navigation/cost_to_go.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <utility>
#include <vector>

#include "base/contracts.h"
#include "tests/common/navigation/map_world.h"

namespace geon::navigation {
namespace {

using Eigen::Vector2d;
using Goals = std::vector<CostToGo::Goal>;

// A square world of which all is seen, and what it costs to come to its goals.
struct World {
  explicit World(const std::vector<Vector2d>& obstacles_W_m, double half_m = 2.0,
                 const CostToGoOptions& wanted = {}, bool seen = true)
      : options(wanted), cost(wanted) {
    if (seen) SeeAllFloor(half_m, &grid);
    Put(obstacles_W_m, &grid);
    clearance.Compute(grid, WindowAround(half_m, grid));
  }
  void To(const Goals& goals) { cost.Compute(grid, clearance, goals); }
  void To(const Vector2d& p_W_m) { To(Goals{{grid.CellAt(p_W_m), 0.0}}); }
  double At(const Vector2d& p_W_m) const { return cost.At(grid.CellAt(p_W_m)); }

  CostToGoOptions options;
  OccupancyGrid grid{OccupancyGridOptions()};
  ClearanceField clearance;
  CostToGo cost;
};

// Points, walls and goals anywhere.
std::vector<Vector2d> RandomObstacles(double half_m, std::mt19937* random) {
  std::uniform_real_distribution<double> coordinate_m(-half_m, half_m);
  const auto place = [&]() -> Vector2d { return {coordinate_m(*random), coordinate_m(*random)}; };
  std::vector<Vector2d> points_m;
  for (auto i = (*random)() % 8; i > 0; --i) points_m.push_back(place());
  for (auto i = (*random)() % 4; i > 0; --i) Append(Wall(place(), place()), &points_m);
  return points_m;
}

Goals RandomGoals(const World& world, std::mt19937* random) {
  const GridWindow& window = world.clearance.window();
  std::uniform_int_distribution<int> x(window.first.x - 3, window.last.x + 3);
  std::uniform_real_distribution<double> cost_m(0.0, 1.5);
  Goals goals(1 + (*random)() % 6);
  for (CostToGo::Goal& goal : goals) goal = {{x(*random), x(*random)}, cost_m(*random)};
  return goals;
}

// Dijkstra with a queue, no more: costs of all cells of the window, row by row.
std::vector<double> DijkstraCosts(const World& world, const Goals& goals) {
  constexpr double kTooNear_1 = 20.0;  // a metre on the way out
  const ClearanceField& clearance = world.clearance;
  const CostToGoOptions& options = world.options;
  const double cell_m = world.grid.cell_m();
  std::vector<double> cost_m(clearance.window().size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::pair<int, int>>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto offer = [&](GridCell cell, double offered_m) {
    if (offered_m >= cost_m[clearance.window().Index(cell)]) return;
    cost_m[clearance.window().Index(cell)] = offered_m;
    queue.push({offered_m, {cell.x, cell.y}});
  };
  const auto least_m = static_cast<float>(options.least_clearance_m);
  const auto too_near = [&](GridCell cell) { return clearance.At(cell) < least_m; };
  for (const CostToGo::Goal& goal : goals) {
    if (clearance.window().Contains(goal.cell) && !too_near(goal.cell))
      offer(goal.cell, goal.cost_m);
  }
  while (!queue.empty()) {
    const auto [now_m, at] = queue.top();
    queue.pop();
    const GridCell cell{at.first, at.second};
    if (now_m > cost_m[clearance.window().Index(cell)]) continue;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const GridCell from{cell.x + dx, cell.y + dy};
        if (from == cell || !clearance.window().Contains(from)) continue;
        if (clearance.At(from) < 1.5F * static_cast<float>(cell_m)) continue;
        if (too_near(cell) && !too_near(from)) continue;
        double metre_m = 1.0;
        if (too_near(from)) {
          metre_m = kTooNear_1;
        } else if (clearance.At(from) < options.easy_clearance_m) {
          const double crowded_1 = (options.easy_clearance_m - clearance.At(from)) /
                                   (options.easy_clearance_m - options.least_clearance_m);
          metre_m += options.crowding_1 * crowded_1 * crowded_1;
        }
        if (!world.grid.IsSeen(from)) metre_m += options.unseen_1;
        offer(from, now_m + metre_m * cell_m * std::hypot(dx, dy));
      }
    }
  }
  return cost_m;
}

void ExpectDijkstra(const World& world, const Goals& goals) {
  const std::vector<double> expected_m = DijkstraCosts(world, goals);
  int differing = 0;
  ForEachCell(world.clearance.window(), [&](GridCell cell) {
    const double cost_m = world.cost.At(cell);
    const double other_m = expected_m[world.clearance.window().Index(cell)];
    const bool same = std::isinf(other_m)
                          ? std::isinf(cost_m)
                          : std::abs(cost_m - other_m) <= 1e-3 * std::max(other_m, 0.01);
    if (!same) ++differing;
  });
  EXPECT_EQ(differing, 0) << "of " << world.clearance.window().size() << " cells";
}

TEST(CostToGoTest, OnFreeSeenFloorItIsTheDistance) {
  World world({});
  const Vector2d goal_m(0.525, -0.225);
  world.To(goal_m);
  ForEachCell(world.clearance.window(), [&](GridCell cell) {
    const double distance_m = (world.grid.Middle(cell) - goal_m).norm();
    EXPECT_GE(world.cost.At(cell), distance_m - 1e-4);
    EXPECT_LE(world.cost.At(cell), 1.083 * distance_m + 1e-4);
  });
  EXPECT_FALSE(world.cost.Next(world.grid.CellAt(goal_m)).has_value());
}

TEST(CostToGoTest, AWallIsDrivenAround) {
  World world(Wall({0.0, -2.0}, {0.0, 1.0}));
  world.To(Vector2d(1.0, 0.0));
  const double least_m = 2.0 * std::hypot(1.0, 1.0 + world.options.least_clearance_m);
  EXPECT_GT(world.At({-1.0, 0.0}), least_m - 0.1);
  EXPECT_LT(world.At({-1.0, 0.0}), 1.5 * least_m);
  EXPECT_LT(world.At({1.0, 1.0}), 1.1);
}

TEST(CostToGoTest, WithoutAWayItIsInfinite) {
  World world(Wall({0.0, -2.0}, {0.0, 2.0}));
  world.To(Vector2d(1.0, 0.0));
  EXPECT_TRUE(std::isinf(world.At({-1.0, 0.0})));
  EXPECT_FALSE(world.cost.Next(world.grid.CellAt({-1.0, 0.0})).has_value());
  EXPECT_TRUE(std::isinf(world.At({5.0, 0.0}))) << "off the window";
  world.To(Goals{});
  EXPECT_TRUE(std::isinf(world.At({1.0, 0.0})));
}

TEST(CostToGoTest, GoalsOffTheWindowOrTooNearToAnObstacleCountForNothing) {
  World world({{0.0, 0.0}});
  world.To(Goals{{world.grid.CellAt({0.2, 0.0}), 0.0}, {{1000, 0}, 0.0}});
  EXPECT_TRUE(std::isinf(world.At({1.0, 0.0})));
}

TEST(CostToGoTest, TheCheaperOfTwoGoalsIsChosen) {
  World world({});
  world.To(Goals{{world.grid.CellAt({1.01, 0.01}), 0.8}, {world.grid.CellAt({-1.01, 0.01}), 0.2}});
  EXPECT_NEAR(world.At({0.01, 0.01}), 1.25, 0.06);
  EXPECT_NEAR(world.At({0.91, 0.01}), 0.9, 0.01);
  EXPECT_NEAR(world.At({1.01, 0.01}), 0.8, 0.01);
}

TEST(CostToGoTest, AGoalHasNoNext) {
  World world({});
  std::mt19937 random(8);
  for (int round = 0; round < 50; ++round) {
    const Goals goals = RandomGoals(world, &random);
    world.To(goals);
    for (const CostToGo::Goal& goal : goals) {
      if (!world.clearance.window().Contains(goal.cell)) continue;
      if (world.cost.At(goal.cell) < static_cast<float>(goal.cost_m)) continue;  // another's
      EXPECT_FALSE(world.cost.Next(goal.cell).has_value()) << "round " << round;
    }
  }
}

TEST(CostToGoTest, AGapIsOpenOnlyWhereTheRobotFits) {
  const double least_m = CostToGoOptions().least_clearance_m;
  const auto cost_through = [](double gap_m) {
    std::vector<Vector2d> points_m = Wall({0.01, -2.0}, {0.01, -0.5 * gap_m + 0.025});
    Append(Wall({0.01, 0.5 * gap_m + 0.025}, {0.01, 2.0}), &points_m);
    World world(points_m);
    world.To(Vector2d(1.0, 0.0));
    return world.At({-1.0, 0.0});
  };
  EXPECT_TRUE(std::isinf(cost_through(2.0 * least_m - 0.03)));
  EXPECT_TRUE(std::isfinite(cost_through(2.0 * least_m + 0.03)));
  EXPECT_GT(cost_through(2.0 * least_m + 0.03), cost_through(1.2)) << "crowded";
}

TEST(CostToGoTest, FromTooNearTheWayLeadsOut) {
  World world(Wall({0.01, -1.0}, {0.01, 1.0}));
  world.To(Vector2d(1.5, 0.0));
  const double out_m = world.At({-0.5, 0.0});
  GridCell cell = world.grid.CellAt({-0.12, 0.0});
  ASSERT_LT(world.clearance.At(cell), world.options.least_clearance_m);
  EXPECT_GT(world.cost.At(cell), out_m);
  bool was_out = false;
  while (const auto next = world.cost.Next(cell)) {
    cell = *next;
    const bool out = world.clearance.At(cell) >= world.options.least_clearance_m;
    EXPECT_TRUE(out || !was_out) << "once out, it stays out";
    was_out = was_out || out;
    const Vector2d p_m = world.grid.Middle(cell);
    EXPECT_FALSE(p_m.x() > -0.1 && p_m.x() < 0.1 && std::abs(p_m.y()) < 1.0) << "through the wall";
  }
  EXPECT_TRUE(was_out);
}

// A square room of this half side, turned.
std::vector<Vector2d> TurnedRoom(double half_m, double angle_rad) {
  std::vector<Vector2d> corners_m;
  for (int i = 0; i < 4; ++i) {
    const double corner_rad = angle_rad + 0.5 * M_PI * i;
    corners_m.emplace_back(half_m * std::sqrt(2.0) *
                           Vector2d(std::cos(corner_rad), std::sin(corner_rad)));
  }
  return ClosedWall(corners_m);
}

TEST(CostToGoTest, NoWayLeadsThroughASlantedWallEvenFromTooNear) {
  constexpr double kHalf_m = 1.0;
  for (int round = 0; round < 90; ++round) {
    const double angle_rad = M_PI * round / 180.0;
    World world(TurnedRoom(kHalf_m, angle_rad), 2.0, {}, false);
    world.To(Vector2d(0.0, 0.0));
    int leaks = 0;
    ForEachCell(world.clearance.window(), [&](GridCell cell) {
      const Vector2d p_m = Eigen::Rotation2Dd(0.25 * M_PI - angle_rad) * world.grid.Middle(cell);
      const bool outside = std::max(std::abs(p_m.x()), std::abs(p_m.y())) > kHalf_m;
      if (outside && std::isfinite(world.cost.At(cell))) ++leaks;
    });
    EXPECT_EQ(leaks, 0) << "turned by " << round << " degrees";
  }
}

TEST(CostToGoTest, NoWayLeadsThroughADiagonalWallOfOnePointPerCell) {
  std::vector<Vector2d> points_m;
  for (int i = -40; i < 40; ++i) points_m.emplace_back(0.05 * i + 0.025, 0.05 * i + 0.025);
  World world(points_m);
  world.To(Vector2d(1.0, -1.0));
  EXPECT_TRUE(std::isinf(world.At({-0.1, 0.1})));
}

TEST(CostToGoTest, OutOfATooNarrowGapTheWayLeadsToEitherSide) {
  std::vector<Vector2d> points_m = Wall({0.01, -2.0}, {0.01, -0.125});
  Append(Wall({0.01, 0.175}, {0.01, 2.0}), &points_m);
  World world(points_m);
  world.To(Vector2d(1.0, 0.0));
  ASSERT_TRUE(std::isinf(world.At({-1.0, 0.0})));
  EXPECT_TRUE(std::isfinite(world.At({-0.15, 0.025})));
}

TEST(CostToGoTest, NextLeadsFromEveryReachableCellToAGoalAtFallingCosts) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    World world(RandomObstacles(2.0, &random), 2.0, {}, seed % 2 == 0);
    const Goals goals = RandomGoals(world, &random);
    world.To(goals);
    ForEachCell(world.clearance.window(), [&](GridCell start) {
      if (!std::isfinite(world.cost.At(start))) {
        EXPECT_FALSE(world.cost.Next(start).has_value());
        return;
      }
      GridCell cell = start;
      bool falls = true;
      while (const auto next = world.cost.Next(cell)) {
        falls = world.cost.At(*next) < world.cost.At(cell);
        if (!falls) break;
        cell = *next;
      }
      EXPECT_TRUE(falls) << "seed " << seed;
      EXPECT_TRUE(std::any_of(goals.begin(), goals.end(),
                              [&](const CostToGo::Goal& goal) { return goal.cell == cell; }))
          << "seed " << seed;
    });
  }
}

TEST(CostToGoTest, UnseenFloorCostsMore) {
  World seen({});
  World unseen({}, 2.0, {}, false);
  seen.To(Vector2d(1.0, 0.0));
  unseen.To(Vector2d(1.0, 0.0));
  EXPECT_NEAR(unseen.At({-1.0, 0.0}), (1.0 + unseen.options.unseen_1) * seen.At({-1.0, 0.0}), 1e-3);
}

TEST(CostToGoTest, CostsAreThoseOfDijkstra) {
  std::mt19937 random(31);
  for (int round = 0; round < 50; ++round) {
    World world(RandomObstacles(2.0, &random), 2.0, {}, round % 5 == 0);
    const Goals goals = RandomGoals(world, &random);
    world.To(goals);
    SCOPED_TRACE(round);
    ExpectDijkstra(world, goals);
  }
}

TEST(CostToGoTest, CostsAreThoseOfDijkstraWhereGapsAreVeryUnwelcome) {
  CostToGoOptions options;
  options.crowding_1 = 40.0;
  options.unseen_1 = 3.0;
  std::mt19937 random(32);
  for (int round = 0; round < 10; ++round) {
    World world(RandomObstacles(2.0, &random), 2.0, options, false);
    const Goals goals = RandomGoals(world, &random);
    world.To(goals);
    SCOPED_TRACE(round);
    ExpectDijkstra(world, goals);
  }
}

TEST(CostToGoTest, RefusesOptionsThatCannotWork) {
  EXPECT_FALSE(CostToGoOptions().Validate().has_value());
  const auto refuses = [](double least_m, double easy_m, double crowding_1, double unseen_1) {
    const CostToGoOptions options{least_m, easy_m, crowding_1, unseen_1};
    EXPECT_TRUE(options.Validate().has_value());
    EXPECT_THROW(CostToGo{options}, ContractViolation);
  };
  refuses(0.0, 0.5, 2.0, 0.3);
  refuses(0.5, 0.5, 2.0, 0.3);
  refuses(0.3, 0.5, -1.0, 0.3);
  refuses(0.3, 0.5, 2.0, -0.1);
}

}  // namespace
}  // namespace geon::navigation
