#include "navigation/occupancy_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "base/contracts.h"

namespace geon::navigation {
namespace {

using Eigen::Vector2d;

constexpr double kNothing_m = std::numeric_limits<double>::quiet_NaN();
const geometry::RigidTransform kStart = geometry::PlanarPose(0.0, 0.0, 0.0);

// One column straight ahead: floor from 0.35 m on.
std::vector<FloorColumn> Ahead(double end_m, bool obstacle) {
  return {{{0.35, 0.0}, {end_m, 0.0}, obstacle}};
}

// What the sonar ahead hears where the robot started; the others hear nothing.
sensor::SonarScan Heard(double range_m) {
  sensor::SonarScan scan;
  scan.range_m.fill(kNothing_m);
  scan.range_m[0] = range_m;
  return scan;
}

// The reading with which the sonar ahead puts an obstacle at `x_m`.
double ReadingFor(double x_m) { return x_m - RingOptions().sonar_radius_m; }

bool IsObstacle(const OccupancyGrid& grid, const Vector2d& p_W_m) {
  return grid.ObstacleIn(grid.CellAt(p_W_m)).has_value();
}

size_t CountObstacles(const OccupancyGrid& grid) {
  std::vector<Vector2d> points_W_m;
  grid.ObstaclesNear({0.0, 0.0}, 100.0, &points_W_m);
  return points_W_m.size();
}

TEST(OccupancyGridTest, OneNearPictureMakesAnObstacleWhereItWasMet) {
  OccupancyGrid grid({});
  const auto pose = geometry::PlanarPose(0.31, -0.2, 0.5 * M_PI);
  grid.SeeFloor(0.0, pose, Ahead(1.013, true));
  const Vector2d met_W_m(0.31, 0.813);
  const auto obstacle_W_m = grid.ObstacleIn(grid.CellAt(met_W_m));
  ASSERT_TRUE(obstacle_W_m.has_value());
  EXPECT_LT((*obstacle_W_m - met_W_m).norm(), 1e-6);
  EXPECT_EQ(CountObstacles(grid), 1u);
}

TEST(OccupancyGridTest, FloorSeenThereLaterTakesItAway) {
  OccupancyGrid grid({});
  grid.SeeFloor(0.0, kStart, Ahead(1.01, true));
  const int64_t revision = grid.revision();
  for (int i = 0; i < 3; ++i) grid.SeeFloor(0.1, kStart, Ahead(2.0, false));
  EXPECT_FALSE(IsObstacle(grid, {1.01, 0.0}));
  EXPECT_GT(grid.revision(), revision);
}

TEST(OccupancyGridTest, FloorIsNotBelievedJustBeforeAnObstacle) {
  OccupancyGrid grid({});
  grid.SeeFloor(0.0, kStart, Ahead(1.01, true));
  EXPECT_TRUE(grid.IsSeen(grid.CellAt({0.81, 0.0})));
  EXPECT_FALSE(grid.IsSeen(grid.CellAt({0.97, 0.0})));
  EXPECT_FALSE(grid.IsSeen(grid.CellAt({1.2, 0.0})));
}

TEST(OccupancyGridTest, AColumnWithoutAnyFloorSaysNothing) {
  OccupancyGrid grid({});
  for (int i = 0; i < 5; ++i) grid.SeeFloor(0.0, kStart, Ahead(0.35, true));
  EXPECT_FALSE(grid.known().has_value());
  EXPECT_EQ(grid.revision(), 0);
  grid.SeeFloor(0.0, kStart, Ahead(0.35, false));
  EXPECT_FALSE(grid.IsSeen(grid.CellAt({0.35, 0.0})));
}

TEST(OccupancyGridTest, ManyColumnsOfOnePictureCountOnceInACell) {
  OccupancyGridOptions options;
  options.seen_obstacle_1 = 0.5;  // below occupied_1
  OccupancyGrid grid(options);
  std::vector<FloorColumn> columns;
  for (int i = 0; i < 5; ++i) columns.push_back({{0.35, 0.0}, {1.01 + 0.005 * i, 0.01}, true});
  grid.SeeFloor(0.0, kStart, columns);
  EXPECT_EQ(CountObstacles(grid), 0u);
  grid.SeeFloor(0.0, kStart, columns);
  EXPECT_EQ(CountObstacles(grid), 1u);
}

TEST(OccupancyGridTest, AFarPictureCountsLess) {
  OccupancyGrid grid({});
  grid.SeeFloor(0.0, kStart, Ahead(2.9, true));  // a quarter
  EXPECT_FALSE(IsObstacle(grid, {2.9, 0.0}));
  for (int i = 0; i < 2; ++i) grid.SeeFloor(0.0, kStart, Ahead(2.9, true));
  EXPECT_TRUE(IsObstacle(grid, {2.9, 0.0}));
}

TEST(OccupancyGridTest, AnEchoIsAnObstacleOnItsSensorsAxis) {
  OccupancyGrid grid({});
  sensor::SonarScan scan = Heard(kNothing_m);
  scan.x_m = 0.5;
  scan.y_m = 1.0;
  scan.heading_rad = 0.3;
  scan.range_m[4] = 1.0;  // to the left
  grid.Hear(0.0, scan, {});
  const Vector2d met_W_m = Vector2d(0.5, 1.0) + (RingOptions().sonar_radius_m + 1.0) *
                                                    Vector2d(-std::sin(0.3), std::cos(0.3));
  const auto obstacle_W_m = grid.ObstacleIn(grid.CellAt(met_W_m));
  ASSERT_TRUE(obstacle_W_m.has_value());
  EXPECT_LT((*obstacle_W_m - met_W_m).norm(), 1e-6);
  EXPECT_EQ(CountObstacles(grid), 1u);
}

TEST(OccupancyGridTest, AnEchoThatSomethingSeenBesideTheAxisExplainsIsNoOther) {
  // At 1 m the arc reaches 22 cm to either side.
  const auto is_added = [](const Vector2d& seen_W_m) {
    OccupancyGrid grid({});
    grid.SeeFloor(0.0, kStart, std::vector<FloorColumn>{{0.4 * seen_W_m, seen_W_m, true}});
    grid.Hear(0.0, Heard(ReadingFor(1.0)), {});
    return IsObstacle(grid, {1.0, 0.01});
  };
  EXPECT_FALSE(is_added({0.98, 0.16}));
  EXPECT_FALSE(is_added({0.98, -0.16}));
  EXPECT_TRUE(is_added({0.93, 0.4})) << "off the arc";
  EXPECT_TRUE(is_added({1.25, 0.2})) << "behind it";
  EXPECT_TRUE(is_added({0.75, 0.1})) << "before it";
}

TEST(OccupancyGridTest, AFarEchoIsNoObstacle) {
  OccupancyGrid grid({});
  grid.Hear(0.0, Heard(RingOptions().sonar_max_m + 0.01), {});
  EXPECT_EQ(CountObstacles(grid), 0u);
}

TEST(OccupancyGridTest, AnEchoFromWhereFloorWasSurelySeenIsOfSomethingElse) {
  OccupancyGrid grid({});
  grid.SeeFloor(0.0, kStart, Ahead(2.0, false));
  grid.Hear(0.0, Heard(ReadingFor(1.01)), {});
  EXPECT_FALSE(IsObstacle(grid, {1.01, 0.0}));

  OccupancyGrid other({});
  other.Hear(0.0, Heard(ReadingFor(1.01)), {});
  EXPECT_TRUE(IsObstacle(other, {1.01, 0.0}));
  other.SeeFloor(0.1, kStart, Ahead(2.0, false));
  EXPECT_FALSE(IsObstacle(other, {1.01, 0.0})) << "nor does it stand when floor is seen later";
}

TEST(OccupancyGridTest, SilenceTakesAwayWhatWasHeardButNeverWhatWasSeen) {
  OccupancyGrid seen({});
  OccupancyGrid heard({});
  seen.SeeFloor(0.0, kStart, Ahead(1.01, true));
  heard.Hear(0.0, Heard(ReadingFor(1.01)), {});
  EXPECT_TRUE(IsObstacle(heard, {1.01, 0.0}));
  for (int i = 0; i < 40; ++i) {
    // Something else behind it, each time a little farther: readings that changed.
    seen.Hear(0.0, Heard(1.7 + 0.001 * i), {});
    heard.Hear(0.0, Heard(1.7 + 0.001 * i), {});
  }
  EXPECT_TRUE(IsObstacle(seen, {1.01, 0.0}));
  EXPECT_FALSE(IsObstacle(heard, {1.01, 0.0}));
}

TEST(OccupancyGridTest, AnEchoDoesNotMoveWhatTheCameraSaw) {
  OccupancyGrid grid({});
  grid.SeeFloor(0.0, kStart, Ahead(1.01, true));
  grid.Hear(0.0, Heard(ReadingFor(1.04)), {});
  const auto obstacle_W_m = grid.ObstacleIn(grid.CellAt({1.01, 0.0}));
  ASSERT_TRUE(obstacle_W_m.has_value());
  EXPECT_NEAR(obstacle_W_m->x(), 1.01, 1e-6);
}

TEST(OccupancyGridTest, AnUnchangedReadingCountsOnce) {
  OccupancyGridOptions options;
  options.heard_1 = 0.4;  // twice would be an obstacle
  OccupancyGrid grid(options);
  for (int i = 0; i < 10; ++i) grid.Hear(0.0, Heard(ReadingFor(1.01)), {});
  EXPECT_FALSE(IsObstacle(grid, {1.01, 0.0}));
  grid.Hear(0.0, Heard(ReadingFor(1.02)), {});
  EXPECT_TRUE(IsObstacle(grid, {1.01, 0.0}));

  OccupancyGrid silence({});
  silence.Hear(0.0, Heard(ReadingFor(1.01)), {});
  for (int i = 0; i < 40; ++i) silence.Hear(0.0, Heard(kNothing_m), {});
  EXPECT_TRUE(IsObstacle(silence, {1.01, 0.0})) << "silence that goes on is one silence";
}

TEST(OccupancyGridTest, OneFiringCountsOnceInACell) {
  // Near the ring the cone is not much wider than a cell: 0.8 heard, 0.35 less, is still above 0.2.
  OccupancyGridOptions options;
  options.heard_1 = 0.8;
  int forgotten = 0;
  for (int degree = 0; degree < 360; ++degree) {
    OccupancyGrid grid(options);
    sensor::SonarScan scan = Heard(ReadingFor(0.67));
    scan.heading_rad = M_PI / 180.0 * degree;
    grid.Hear(0.0, scan, {});
    ASSERT_EQ(CountObstacles(grid), 1u);
    scan.range_m[0] = kNothing_m;
    grid.Hear(0.0, scan, {});
    if (CountObstacles(grid) == 0) ++forgotten;
  }
  EXPECT_EQ(forgotten, 0) << "of 360 directions";
}

TEST(OccupancyGridTest, WhatWasFeltIsAnObstacleAtOnceAndSoonForgotten) {
  OccupancyGridOptions options;
  OccupancyGrid grid(options);
  const std::vector<Vector2d> felt_R_m = {{0.267, 0.0}};
  grid.Feel(0.0, geometry::PlanarPose(1.01, 1.0, 0.5 * M_PI), felt_R_m);
  EXPECT_TRUE(IsObstacle(grid, {1.01, 1.267}));
  for (int i = 1; i <= 10; ++i) grid.Feel(0.4 * i * options.felt_memory_s, kStart, {});
  EXPECT_FALSE(IsObstacle(grid, {1.01, 1.267}));
}

TEST(OccupancyGridTest, EvidenceFadesWhatWasSeenSlowest) {
  OccupancyGridOptions options;
  OccupancyGrid grid(options);
  for (int i = 0; i < 3; ++i) grid.SeeFloor(0.0, kStart, Ahead(1.01, true));
  sensor::SonarScan scan = Heard(kNothing_m);
  scan.range_m[4] = 1.0;
  grid.Hear(0.0, scan, {});
  for (double now_s = 0.0; now_s < 3.0 * options.heard_memory_s; now_s += 0.2) {
    grid.Feel(now_s, kStart, {});
  }
  EXPECT_TRUE(IsObstacle(grid, {1.01, 0.0}));
  EXPECT_FALSE(IsObstacle(grid, {0.0, 1.225}));
  for (int i = 1; i <= 10; ++i) {
    grid.Feel((3.0 + i) * options.heard_memory_s + 0.5 * i * options.seen_memory_s, kStart, {});
  }
  EXPECT_EQ(CountObstacles(grid), 0u);
  EXPECT_FALSE(grid.IsSeen(grid.CellAt({0.8, 0.0})));
}

TEST(OccupancyGridTest, EvidenceDoesNotAgeBeforeItIsThere) {
  OccupancyGrid grid({});
  const std::vector<Vector2d> felt_R_m = {{0.267, 0.0}};
  grid.Feel(0.0, kStart, {});
  grid.Feel(100.0, kStart, felt_R_m);
  grid.Feel(100.6, kStart, {});
  EXPECT_TRUE(IsObstacle(grid, felt_R_m[0]));
}

TEST(OccupancyGridTest, ForgetDoubtfulKeepsFirmThingsAndDropsWeakOnes) {
  OccupancyGrid grid({});
  const std::vector<FloorColumn> twice = {{{0.35, 0.0}, {1.01, 0.0}, true}};
  const std::vector<FloorColumn> once = {{{0.2, 0.3}, {0.61, 0.91}, true}};
  for (int i = 0; i < 2; ++i) grid.SeeFloor(0.0, kStart, twice);
  grid.SeeFloor(0.0, kStart, once);
  sensor::SonarScan scan = Heard(kNothing_m);
  scan.range_m[4] = 1.5;
  grid.Hear(0.0, scan, {});
  ASSERT_EQ(CountObstacles(grid), 3u);
  const int64_t revision = grid.revision();
  grid.ForgetDoubtful();
  EXPECT_EQ(CountObstacles(grid), 1u);
  EXPECT_TRUE(IsObstacle(grid, {1.01, 0.0}));
  EXPECT_EQ(grid.revision(), revision + 2);
  EXPECT_TRUE(grid.IsSeen(grid.CellAt({0.8, 0.0}))) << "floor is not forgotten";
}

TEST(OccupancyGridTest, WhatIsBrightIsDoubtedForSomeTimeButNotWhatIsHeardThere) {
  OccupancyGridOptions options;
  options.doubt_s = 2.0;
  OccupancyGrid grid(options);
  const std::vector<FloorColumn> columns = {{{0.35, 0.0}, {1.01, 0.0}, true, true},
                                            {{0.2, 0.3}, {0.61, 0.91}, true, false}};
  EXPECT_FALSE(grid.DoubtBright(0.0)) << "nothing to doubt";
  grid.SeeFloor(0.0, kStart, columns);
  ASSERT_TRUE(IsObstacle(grid, {1.01, 0.0}));
  ASSERT_TRUE(grid.DoubtBright(0.0));
  EXPECT_FALSE(IsObstacle(grid, {1.01, 0.0}));
  EXPECT_TRUE(IsObstacle(grid, {0.61, 0.91})) << "it is not bright";
  EXPECT_FALSE(grid.IsSeen(grid.CellAt({1.01, 0.0}))) << "nor is it known to be floor";
  for (int i = 0; i < 5; ++i) grid.SeeFloor(1.9, kStart, columns);
  EXPECT_FALSE(IsObstacle(grid, {1.01, 0.0}));
  EXPECT_FALSE(grid.DoubtBright(1.9)) << "there is none left";
  grid.Hear(1.9, Heard(ReadingFor(1.01)), {});
  EXPECT_TRUE(IsObstacle(grid, {1.01, 0.0}));

  OccupancyGrid later(options);
  later.SeeFloor(0.0, kStart, columns);
  ASSERT_TRUE(later.DoubtBright(0.0));
  later.SeeFloor(2.1, kStart, columns);
  EXPECT_TRUE(IsObstacle(later, {1.01, 0.0})) << "the doubt is over";
  ASSERT_TRUE(later.DoubtBright(2.1));
  later.Clear();
  later.SeeFloor(2.2, kStart, columns);
  EXPECT_TRUE(IsObstacle(later, {1.01, 0.0})) << "whoever forgets all doubts nothing";
}

TEST(OccupancyGridTest, ThingsBeyondTheReachAreIgnoredWithoutHarm) {
  OccupancyGridOptions options;
  options.reach_m = 2.0;
  OccupancyGrid grid(options);
  grid.SeeFloor(0.0, kStart, Ahead(2.6, true));
  EXPECT_TRUE(grid.IsSeen(grid.CellAt({1.0, 0.0})));
  EXPECT_FALSE(grid.IsSeen(grid.CellAt({2.3, 0.0})));
  for (const double x_m : {-50.0, -2.3, 1.9, 2.3, 50.0}) {
    const auto pose = geometry::PlanarPose(x_m, -x_m, 0.7);
    const std::vector<Vector2d> felt_R_m = {{2.0, 0.0}, {-2.0, 0.0}, {0.0, 2.0}};
    grid.SeeFloor(0.0, pose, Ahead(3.0, true));
    grid.Feel(0.0, pose, felt_R_m);
    sensor::SonarScan scan = Heard(1.0);
    scan.x_m = x_m;
    scan.y_m = x_m;
    grid.Hear(0.0, scan, {});
  }
  EXPECT_FALSE(grid.ObstacleIn(grid.CellAt({50.0, 50.0})).has_value());
  ASSERT_TRUE(grid.known().has_value());
  EXPECT_TRUE(grid.Covers(grid.known()->first));
  EXPECT_TRUE(grid.Covers(grid.known()->last));
  EXPECT_FALSE(grid.Covers({grid.CellAt({2.0, 0.0}).x + 1, 0}));
  std::vector<Vector2d> points_W_m;
  grid.ObstaclesNear({30.0, 30.0}, 1.0, &points_W_m);
  EXPECT_TRUE(points_W_m.empty());
}

TEST(OccupancyGridTest, ObstaclesNearAreThoseInTheSquare) {
  OccupancyGrid grid({});
  const std::vector<Vector2d> felt_R_m = {{0.5, 0.5}, {-0.9, 0.9}, {1.2, 0.0}};
  grid.Feel(0.0, kStart, felt_R_m);
  std::vector<Vector2d> points_W_m = {{7.0, 7.0}};
  grid.ObstaclesNear({0.0, 0.0}, 1.0, &points_W_m);
  EXPECT_EQ(points_W_m.size(), 2u);
}

TEST(OccupancyGridTest, KnownGrowsWithWhatIsToldAndClearForgetsAll) {
  OccupancyGrid grid({});
  EXPECT_FALSE(grid.known().has_value());
  EXPECT_EQ(grid.revision(), 0);
  const std::vector<Vector2d> felt_R_m = {{-1.01, 0.51}, {0.51, 0.26}};
  grid.Feel(0.0, kStart, felt_R_m);
  ASSERT_TRUE(grid.known().has_value());
  EXPECT_EQ(grid.known()->first, grid.CellAt({-1.01, 0.26}));
  EXPECT_EQ(grid.known()->last, grid.CellAt({0.51, 0.51}));
  EXPECT_EQ(grid.revision(), 2);
  grid.Feel(0.1, kStart, felt_R_m);
  EXPECT_EQ(grid.revision(), 2) << "nothing became an obstacle or ceased to be one";
  grid.SeeFloor(0.1, kStart, Ahead(1.5, false));
  grid.Clear();
  EXPECT_FALSE(grid.known().has_value());
  EXPECT_GT(grid.revision(), 2);
  EXPECT_EQ(CountObstacles(grid), 0u);
  EXPECT_FALSE(IsObstacle(grid, felt_R_m[0]));
  EXPECT_FALSE(grid.IsSeen(grid.CellAt({1.0, 0.0})));
  grid.Hear(0.2, Heard(ReadingFor(1.01)), {});
  EXPECT_TRUE(IsObstacle(grid, {1.01, 0.0}));
  grid.Clear();
  grid.Hear(0.3, Heard(ReadingFor(1.01)), {});
  EXPECT_TRUE(IsObstacle(grid, {1.01, 0.0})) << "the same reading as before says something again";
}

TEST(OccupancyGridTest, RefusesOptionsThatCannotWork) {
  const std::vector<std::function<void(OccupancyGridOptions*)>> mistakes = {
      [](OccupancyGridOptions* o) { o->cell_m = 0.0; },
      [](OccupancyGridOptions* o) { o->cell_m = kNothing_m; },
      [](OccupancyGridOptions* o) { o->reach_m = 0.01; },
      [](OccupancyGridOptions* o) { o->reach_m = 1e4; },
      [](OccupancyGridOptions* o) { o->seen_obstacle_1 = 0.0; },
      [](OccupancyGridOptions* o) { o->seen_floor_1 = 0.7; },
      [](OccupancyGridOptions* o) { o->silent_1 = 0.0; },
      [](OccupancyGridOptions* o) { o->most_heard_1 = o->occupied_1; },
      [](OccupancyGridOptions* o) { o->free_again_1 = o->occupied_1; },
      [](OccupancyGridOptions* o) { o->near_m = 0.0; },
      [](OccupancyGridOptions* o) { o->floor_margin_m = -0.1; },
      [](OccupancyGridOptions* o) { o->heard_memory_s = 0.0; },
      [](OccupancyGridOptions* o) { o->doubt_s = -1.0; },
  };
  EXPECT_FALSE(OccupancyGridOptions().Validate().has_value());
  for (size_t i = 0; i < mistakes.size(); ++i) {
    OccupancyGridOptions options;
    mistakes[i](&options);
    EXPECT_TRUE(options.Validate().has_value()) << "mistake " << i;
    EXPECT_THROW(OccupancyGrid{options}, ContractViolation) << "mistake " << i;
  }
}

TEST(OccupancyGridTest, AWindowHoldsAllThatIsKnownAndThePlacesWithTheirMargin) {
  OccupancyGrid grid{OccupancyGridOptions()};
  const std::vector<Vector2d> places_m = {{0.52, -0.31}, {1.22, 0.4}};
  const GridWindow around = grid.WindowWith(places_m, 0.5);
  EXPECT_EQ(around.first, grid.CellAt({0.02, -0.81}));
  EXPECT_EQ(around.last, grid.CellAt({1.72, 0.9}));
  grid.Feel(0.0, kStart, std::vector<Vector2d>{{-3.02, 0.02}, {1.0, 2.52}});
  const GridWindow whole = grid.WindowWith(places_m, 0.5);
  EXPECT_EQ(whole.first, grid.CellAt({-3.02, -0.81}));
  EXPECT_EQ(whole.last, grid.CellAt({1.72, 2.52}));
  const OccupancyGrid blank{OccupancyGridOptions()};
  const GridWindow one = blank.WindowWith(std::vector<Vector2d>{{-2.0, 3.0}}, 0.0);
  EXPECT_EQ(one.size(), 1U) << "the origin is not known of";
  EXPECT_THROW(grid.WindowWith({}, 1.0), ContractViolation);
}

}  // namespace
}  // namespace geon::navigation
