#include "navigation/viewing_positions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angles.h"
#include "tests/common/navigation/map_world.h"

namespace geon::navigation {
namespace {

using Eigen::Vector2d;

constexpr double kOwn_m = 0.6;

struct Room {
  OccupancyGrid grid{OccupancyGridOptions()};
  ClearanceField clearance;
  std::vector<CostToGo::Goal> goals;
};

Room LookAt(const Vector2d& target_W_m, const std::vector<Vector2d>& obstacles_W_m,
            double window_half_m = 3.0) {
  Room room;
  Put(obstacles_W_m, &room.grid);
  room.clearance.Compute(room.grid, WindowAround(window_half_m, room.grid));
  room.goals = ViewingPositions(room.grid, room.clearance, target_W_m, kOwn_m, {});
  return room;
}

TEST(ViewingPositionsTest, AreAllThePlacesOfTheRing) {
  const ViewingOptions options;
  const Vector2d target_W_m(0.513, -0.207);
  const Room room = LookAt(target_W_m, {});
  size_t in_ring = 0;
  ForEachCell(room.clearance.window(), [&](GridCell cell) {
    const double distance_m = (room.grid.Middle(cell) - target_W_m).norm();
    if (distance_m <= options.distance_m && distance_m >= options.distance_m - options.nearer_m) {
      ++in_ring;
    }
  });
  EXPECT_EQ(room.goals.size(), in_ring);
  EXPECT_GT(in_ring, 100u);
  for (const CostToGo::Goal& goal : room.goals) {
    const double distance_m = (room.grid.Middle(goal.cell) - target_W_m).norm();
    EXPECT_LE(distance_m, options.distance_m);
    EXPECT_GE(distance_m, options.distance_m - options.nearer_m);
    EXPECT_EQ(goal.cost_m, 0.0);
  }
}

TEST(ViewingPositionsTest, AreCellsOfTheWindow) {
  const Room room = LookAt({1.0, 0.0}, {}, 1.0);
  EXPECT_FALSE(room.goals.empty());
  for (const CostToGo::Goal& goal : room.goals)
    EXPECT_TRUE(room.clearance.window().Contains(goal.cell));
  EXPECT_TRUE(LookAt({9.0, 0.0}, {}, 1.0).goals.empty());
}

TEST(ViewingPositionsTest, ThoseBehindAnObstacleCostMore) {
  // A wall to the right of the target, as wide as what lies more than 45 degrees off is not hidden.
  const Room room = LookAt({0.0, 0.0}, Wall({0.7, -0.7}, {0.7, 0.7}));
  size_t hidden = 0;
  for (const CostToGo::Goal& goal : room.goals) {
    const Vector2d p_m = room.grid.Middle(goal.cell);
    const double bearing_rad = std::abs(std::atan2(p_m.y(), p_m.x()));
    if (p_m.x() > 0.75 && bearing_rad < 0.7) {
      EXPECT_EQ(goal.cost_m, ViewingOptions().hidden_cost_m);
      ++hidden;
    } else if (bearing_rad > 0.9) {
      EXPECT_EQ(goal.cost_m, 0.0);
    }
  }
  EXPECT_GT(hidden, 10u);
}

TEST(ViewingPositionsTest, ObstaclesNearTheTargetAreItsOwn) {
  std::vector<Vector2d> desk_m =
      ClosedWall(std::vector<Vector2d>{{-0.4, -0.4}, {0.4, -0.4}, {0.4, 0.4}, {-0.4, 0.4}});
  for (const CostToGo::Goal& goal : LookAt({0.0, 0.0}, desk_m).goals) EXPECT_EQ(goal.cost_m, 0.0);
  Append(Wall({0.68, -0.1}, {0.68, 0.1}), &desk_m);  // not the desk's
  const Room room = LookAt({0.0, 0.0}, desk_m);
  EXPECT_TRUE(std::any_of(room.goals.begin(), room.goals.end(),
                          [](const CostToGo::Goal& goal) { return goal.cost_m > 0.0; }));
}

TEST(ViewingPositionsTest, OfOneSideAreThoseOfTheRingThatLieThere) {
  const Vector2d target_W_m(0.213, -0.107);
  const Room room = LookAt(target_W_m, {});
  const auto bearing_rad = [&](const CostToGo::Goal& goal) {
    const Vector2d out_m = room.grid.Middle(goal.cell) - target_W_m;
    return std::atan2(out_m.y(), out_m.x());
  };
  ViewingOptions options;
  for (const double side_rad : {0.0, 1.9, kPi, -3.0}) {
    options.side_rad = side_rad;
    const auto of_side = ViewingPositions(room.grid, room.clearance, target_W_m, kOwn_m, options);
    const auto lies_there = [&](const CostToGo::Goal& goal) {
      return std::abs(WrapAngle(bearing_rad(goal) - side_rad)) <= options.side_tolerance_rad;
    };
    EXPECT_GT(of_side.size(), 5U);
    EXPECT_TRUE(std::all_of(of_side.begin(), of_side.end(), lies_there));
    EXPECT_EQ(static_cast<ptrdiff_t>(of_side.size()),
              std::count_if(room.goals.begin(), room.goals.end(), lies_there));
  }
}

}  // namespace
}  // namespace geon::navigation
