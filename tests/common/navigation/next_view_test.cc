#include "navigation/next_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "base/angles.h"
#include "base/contracts.h"
#include "tests/common/navigation/map_world.h"

namespace geon::navigation {
namespace {

using Eigen::Vector2d;

constexpr size_t kFirstDesk = ViewCoverage::kFloorOverObstacles + 1;

// A square pen of which the whole floor is known, with walls inside; the robot stands in it.
struct Pen {
  explicit Pen(const std::vector<Vector2d>& walls_W_m, const Vector2d& robot_W_m = {0.0, 0.0}) {
    constexpr double kHalf_m = 2.0;
    SeeAllFloor(kHalf_m, &map);
    Put(ClosedWall(std::vector<Vector2d>{
            {-kHalf_m, -kHalf_m}, {kHalf_m, -kHalf_m}, {kHalf_m, kHalf_m}, {-kHalf_m, kHalf_m}}),
        &map);
    Put(walls_W_m, &map);
    clearance.Compute(map, WindowAround(kHalf_m + 0.5, map));
    drive.Compute(map, clearance, std::vector<CostToGo::Goal>{{map.CellAt(robot_W_m), 0.0}});
  }
  // All places for which `which` holds were looked at, on every plane.
  template <typename Which>
  void MarkAll(Which which) {
    for (double x_m = -4.95; x_m < 5.0; x_m += ViewCoverage::kCell_m) {
      for (double y_m = -4.95; y_m < 5.0; y_m += ViewCoverage::kCell_m) {
        if (!which(Vector2d(x_m, y_m))) continue;
        for (size_t plane = 0; plane < coverage.planes().size(); ++plane) {
          coverage.Mark(plane, {x_m, y_m});
        }
      }
    }
  }
  std::optional<NextPlace> Next(const NextViewOptions& options = {}) const {
    return NextPlaceToLookFrom(
        map, coverage, clearance, drive, [](const Vector2d&) { return false; }, options);
  }

  OccupancyGrid map{OccupancyGridOptions()};
  ViewCoverage coverage{{0.0, 0.7}};
  ClearanceField clearance;
  CostToGo drive{CostToGoOptions()};
};

std::vector<Unlooked> AtBearings(const std::vector<double>& bearings_rad, double area_m2 = 0.1) {
  std::vector<Unlooked> unlooked;
  for (const double bearing_rad : bearings_rad) {
    Unlooked each;
    each.bearing_W_rad = bearing_rad;
    each.area_m2 = area_m2;
    unlooked.push_back(each);
  }
  return unlooked;
}

TEST(UnlookedFromTest, OnOpenFloorItIsTheWholeRing) {
  NextViewOptions options;
  options.floor_far_m = 2.25;  // between two steps outwards
  const OccupancyGrid map{OccupancyGridOptions()};
  const ViewCoverage coverage({0.0, 0.7});
  const Vector2d place_m(0.3, -0.4);
  const auto unlooked = UnlookedFrom(place_m, map, coverage, options);
  const double ring_m2 =
      kPi * (options.farthest_m * options.farthest_m - options.floor_near_m * options.floor_near_m);
  EXPECT_NEAR(AreaOf(unlooked), ring_m2, 0.03 * ring_m2);
  for (const Unlooked& each : unlooked) {
    EXPECT_EQ(each.plane, ViewCoverage::kFloor);
    const Vector2d away_m = each.p_W_m - place_m;
    EXPECT_NEAR(WrapAngle(std::atan2(away_m.y(), away_m.x()) - each.bearing_W_rad), 0.0, 1e-9);
    EXPECT_NEAR(std::tan(each.elevation_rad) * away_m.norm(),
                ViewCoverage::kMiddle_m - options.camera_height_m, 1e-9);
    EXPECT_EQ(each.by_floor_camera, away_m.norm() <= options.floor_far_m);
  }
}

TEST(UnlookedFromTest, WhatTheHeadCannotBePointedAtIsLeftOut) {
  NextViewOptions options;
  options.lowest_rad = -0.4;
  options.floor_far_m = 1.0;
  const auto unlooked =
      UnlookedFrom({0.0, 0.0}, OccupancyGrid{OccupancyGridOptions()}, ViewCoverage({}), options);
  const double lowest_m = (options.camera_height_m - ViewCoverage::kMiddle_m) / std::tan(0.4);
  bool farther = false;
  for (const Unlooked& each : unlooked) {
    if (each.by_floor_camera) continue;
    EXPECT_GE(each.p_W_m.norm(), lowest_m - 1e-9);
    farther = true;
  }
  EXPECT_TRUE(farther);
}

TEST(UnlookedFromTest, WhatWasLookedAtIsLeftOut) {
  Pen pen({});
  const NextViewOptions options;
  const double whole_m2 = AreaOf(UnlookedFrom({0.0, 0.0}, pen.map, pen.coverage, options));
  pen.MarkAll([](const Vector2d& p_m) { return p_m.x() > 0.0; });
  const auto unlooked = UnlookedFrom({0.0, 0.0}, pen.map, pen.coverage, options);
  for (const Unlooked& each : unlooked) EXPECT_LE(each.p_W_m.x(), 1e-9);
  EXPECT_NEAR(AreaOf(unlooked), 0.5 * whole_m2, 0.05 * whole_m2);
  pen.MarkAll([](const Vector2d&) { return true; });
  EXPECT_TRUE(UnlookedFrom({0.0, 0.0}, pen.map, pen.coverage, options).empty());
}

TEST(UnlookedFromTest, FloorEndsAtAnObstacleWhichMayBeADesk) {
  const Pen pen({});
  const auto unlooked = UnlookedFrom({0.0, 0.0}, pen.map, pen.coverage, {});
  size_t desks = 0;
  for (const Unlooked& each : unlooked) {
    ASSERT_NE(each.plane, ViewCoverage::kFloorOverObstacles) << "only where asked for";
    const double to_wall_m = 2.0 / std::max(std::abs(std::cos(each.bearing_W_rad)),
                                            std::abs(std::sin(each.bearing_W_rad)));
    if (each.plane == ViewCoverage::kFloor) {
      EXPECT_LT(each.p_W_m.norm(), to_wall_m);
    } else {
      EXPECT_EQ(each.plane, kFirstDesk);
      EXPECT_NEAR(each.p_W_m.norm(), to_wall_m + 0.1, 0.15);
      ++desks;
    }
  }
  EXPECT_GT(desks, 30U);
}

TEST(UnlookedFromTest, OverObstaclesFloorIsWorthLess) {
  const Pen pen({});
  NextViewOptions options;
  const double before_m2 = AreaOf(UnlookedFrom({0.0, 0.0}, pen.map, pen.coverage, options));
  options.over_obstacles = true;
  std::vector<Unlooked> over = UnlookedFrom({0.0, 0.0}, pen.map, pen.coverage, options);
  const double with_m2 = AreaOf(over);
  std::erase_if(
      over, [](const Unlooked& each) { return each.plane != ViewCoverage::kFloorOverObstacles; });
  ASSERT_FALSE(over.empty());
  for (const Unlooked& each : over) {
    EXPECT_GT(each.p_W_m.cwiseAbs().maxCoeff(), 1.9);
    EXPECT_FALSE(each.by_floor_camera);
  }
  EXPECT_NEAR(with_m2 - before_m2, AreaOf(over), 1e-6);
  const double hidden_m2 = kPi * 25.0 - 16.0;
  EXPECT_LT(AreaOf(over), 0.5 * hidden_m2);
  EXPECT_GT(AreaOf(over), 0.1 * hidden_m2);
}

TEST(ArcOfTest, IsTheShortestThatHoldsAllBearings) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> bearing_rad(-kPi, kPi), spread_rad(0.1, kPi);
  for (int i = 0; i < 300; ++i) {
    const double middle_rad = bearing_rad(random), half_rad = spread_rad(random);
    std::vector<double> bearings_rad(1 + random() % 12);
    for (double& each_rad : bearings_rad) {
      each_rad = WrapAngle(middle_rad + half_rad * bearing_rad(random) / kPi);
    }
    const Arc arc = ArcOf(AtBearings(bearings_rad));
    const auto span_from = [&](double first_rad) {
      double span_rad = 0.0;
      for (const double each_rad : bearings_rad) {
        const double left_rad = WrapAngle(each_rad - first_rad);
        span_rad = std::max(span_rad, left_rad < -1e-9 ? left_rad + 2.0 * kPi : left_rad);
      }
      return span_rad;
    };
    double shortest_rad = 2.0 * kPi;
    for (const double first_rad : bearings_rad) {
      shortest_rad = std::min(shortest_rad, span_from(first_rad));
    }
    EXPECT_NEAR(arc.span_rad, shortest_rad, 1e-6);
    EXPECT_NEAR(span_from(arc.first_rad), arc.span_rad, 1e-6);
  }
}

TEST(ArcOfTest, OfOneBearingOrNoneIsNoTurn) {
  EXPECT_EQ(ArcOf({}).span_rad, 0.0);
  const Arc arc = ArcOf(AtBearings({2.5}));
  EXPECT_EQ(arc.first_rad, 2.5);
  EXPECT_NEAR(arc.span_rad, 0.0, 1e-12);
}

TEST(UtilityTest, IsAreaPerSecondOfDrivingAndTurning) {
  NextViewOptions options;
  options.pause_s = 1.0;
  options.speed_m_s = 0.25;
  options.turn_rate_rad_s = 0.5;
  const auto unlooked = AtBearings({3.0, -3.0, -2.8}, 0.2);
  const double turn_s = (2.0 * kPi - 5.8) / 0.5;
  EXPECT_NEAR(Utility(unlooked, 0.0, options), 0.6 / (1.0 + turn_s), 1e-9);
  EXPECT_NEAR(Utility(unlooked, 2.0, options), 0.6 / (1.0 + 8.0 + turn_s), 1e-9);
}

TEST(UtilityTest, TooLittleIsWorthNothingAndTooMuchCountsNoMore) {
  NextViewOptions options;
  options.least_m2 = 0.5;
  options.most_m2 = 1.0;
  EXPECT_EQ(Utility(AtBearings({0.0}, 0.49), 0.0, options), 0.0);
  EXPECT_EQ(Utility({}, 0.0, options), 0.0);
  EXPECT_GT(Utility(AtBearings({0.0}, 0.51), 3.0, options), 0.0);
  EXPECT_EQ(Utility(AtBearings({0.0}, 1.0), 1.0, options),
            Utility(AtBearings({0.0}, 40.0), 1.0, options));
}

TEST(NextPlaceTest, IsTheBestOfThoseWithinReach) {
  const Pen pen(Wall({0.2, -2.0}, {0.2, 0.9}), {-1.0, -1.0});
  const NextViewOptions options;
  const auto next = pen.Next(options);
  ASSERT_TRUE(next.has_value());
  double most_m2_s = 0.0;
  ForEachCell(pen.drive.window(), [&](GridCell cell) {
    if (cell.x % 5 != 0 || cell.y % 5 != 0) return;
    if (!std::isfinite(pen.drive.At(cell)) || pen.clearance.At(cell) < options.clearance_m) return;
    const auto unlooked = UnlookedFrom(pen.map.Middle(cell), pen.map, pen.coverage, options);
    most_m2_s = std::max(most_m2_s, Utility(unlooked, pen.drive.At(cell), options));
  });
  EXPECT_NEAR(next->utility_m2_s, most_m2_s, 1e-9);
  const auto unlooked = UnlookedFrom(next->place_W_m, pen.map, pen.coverage, options);
  EXPECT_NEAR(next->area_m2, AreaOf(unlooked), 1e-9);
  EXPECT_GE(pen.clearance.At(pen.map.CellAt(next->place_W_m)), options.clearance_m);
}

TEST(NextPlaceTest, LeadsToWhereWhatIsLeftCanBeSeen) {
  // A partition with its open end above; only the floor behind its foot is left.
  Pen pen(Wall({0.2, -2.0}, {0.2, 0.9}), {-1.0, -1.0});
  const auto is_left = [](const Vector2d& p_m) { return p_m.x() > 0.4 && p_m.y() < 0.0; };
  pen.MarkAll([&](const Vector2d& p_m) { return !is_left(p_m); });
  const auto next = pen.Next();
  ASSERT_TRUE(next.has_value());
  EXPECT_TRUE(next->place_W_m.x() > 0.2 || next->place_W_m.y() > 0.9)
      << next->place_W_m.transpose();
  const auto unlooked = UnlookedFrom(next->place_W_m, pen.map, pen.coverage, {});
  EXPECT_GT(AreaOf(unlooked), 1.0);
}

TEST(NextPlaceTest, ThereIsNoneWhenAllWasLookedAt) {
  Pen pen({});
  pen.MarkAll([](const Vector2d&) { return true; });
  EXPECT_FALSE(pen.Next().has_value());
}

TEST(NextPlaceTest, ThereIsNoneWhenTheRestCannotBeReached) {
  // What is left lies behind a wall without a gap.
  Pen pen(Wall({0.0, -2.0}, {0.0, 2.0}), {-1.0, 0.0});
  pen.MarkAll([](const Vector2d& p_m) { return p_m.x() < 0.3; });
  EXPECT_FALSE(pen.Next().has_value());
}

TEST(NextPlaceTest, PlacesThatAreGivenUpAreLeftOut) {
  const Pen pen({});
  const auto first = pen.Next();
  ASSERT_TRUE(first.has_value());
  const auto is_given_up = [&](const Vector2d& p_m) {
    return (p_m - first->place_W_m).norm() < 0.6;
  };
  const auto second =
      NextPlaceToLookFrom(pen.map, pen.coverage, pen.clearance, pen.drive, is_given_up, {});
  ASSERT_TRUE(second.has_value());
  EXPECT_GE((second->place_W_m - first->place_W_m).norm(), 0.6);
  EXPECT_LE(second->utility_m2_s, first->utility_m2_s);
  EXPECT_FALSE(NextPlaceToLookFrom(pen.map, pen.coverage, pen.clearance, pen.drive,
                                   [](const Vector2d&) { return true; }, {})
                   .has_value());
}

TEST(NextViewOptionsTest, RulesAreStatedWhenTheyAreBroken) {
  EXPECT_FALSE(NextViewOptions().Validate().has_value());
  const auto broken = [](auto change) {
    NextViewOptions options;
    change(&options);
    return options.Validate().value_or("");
  };
  using Options = NextViewOptions;
  const auto names = [](const std::string& text, const char* word) {
    return text.find(word) != std::string::npos;
  };
  EXPECT_TRUE(names(broken([](Options* o) { o->camera_height_m = 0.0; }), "camera_height_m"));
  EXPECT_TRUE(names(broken([](Options* o) { o->lowest_rad = 0.3; }), "lowest_rad"));
  EXPECT_TRUE(names(broken([](Options* o) { o->farthest_m = 0.0; }), "farthest_m"));
  EXPECT_TRUE(names(broken([](Options* o) { o->floor_far_m = 0.1; }), "floor_far_m"));
  EXPECT_TRUE(names(broken([](Options* o) { o->speed_m_s = 0.0; }), "speed_m_s"));
  EXPECT_TRUE(names(broken([](Options* o) { o->pause_s = 0.0; }), "pause_s"));
  EXPECT_TRUE(names(broken([](Options* o) { o->least_m2 = 0.0; }), "least_m2"));
  EXPECT_TRUE(names(broken([](Options* o) { o->most_m2 = 0.1; }), "most_m2"));
  EXPECT_TRUE(names(broken([](Options* o) { o->spacing_m = 0.0; }), "spacing_m"));
  EXPECT_TRUE(names(broken([](Options* o) { o->clearance_m = -0.1; }), "clearance_m"));
  NextViewOptions options;
  options.least_m2 = 0.0;
  EXPECT_THROW(Pen({}).Next(options), ContractViolation);
}

}  // namespace
}  // namespace geon::navigation
