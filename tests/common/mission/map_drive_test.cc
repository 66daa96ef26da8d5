#include "mission/map_drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/time.h"
#include "tests/common/mission/trip.h"

namespace geon::mission {
namespace {

using Eigen::Vector2d;

TEST(MapDriveTest, OnFreeFloorItDrivesToTheViewingRing) {
  for (const double bearing_rad : {0.0, 0.8, -2.0, 3.1}) {
    SCOPED_TRACE(bearing_rad);
    Trip trip(3.0 * Vector2d(std::cos(bearing_rad), std::sin(bearing_rad)));
    trip.Run(30.0);
    EXPECT_LE(trip.Distance_m(), kStop_m + kTolerance_m);
    EXPECT_GE(trip.Distance_m(), kStop_m - 0.12);
    EXPECT_FALSE(trip.answer.unreachable.has_value());
    EXPECT_TRUE(trip.Tried().empty()) << trip.Tried()[0];
    EXPECT_GE(trip.nearest_m(), kBody_m);
  }
}

TEST(MapDriveTest, ItStopsNoFartherOffThanAsked) {
  for (const double bearing_rad : {0.0, 0.8, -2.0, 3.1}) {
    SCOPED_TRACE(bearing_rad);
    Trip trip(3.0 * Vector2d(std::cos(bearing_rad), std::sin(bearing_rad)));
    trip.Run(15.0, kStop_m);
    EXPECT_LE(trip.Distance_m(), kStop_m);
  }
}

TEST(MapDriveTest, OnTheViewingRingItStands) {
  Trip trip({3.0, 0.0});
  trip.Run(30.0);
  for (int i = 0; i < 40; ++i) trip.Step();
  EXPECT_GE(trip.Distance_m(), kStop_m - 0.12);
  EXPECT_LE(trip.Distance_m(), kStop_m + kTolerance_m);
  EXPECT_NEAR(trip.answer.velocity.speed_m_s, 0.0, 1e-9);
}

TEST(MapDriveTest, ItGetsRoundAUThatIsOpenTowardsIt) {
  Trip trip({3.4, 0.0});
  trip.AddBlock({1.6, 0.0}, {0.04, 0.6});
  trip.AddBlock({1.25, 0.6}, {0.39, 0.04});
  trip.AddBlock({1.25, -0.6}, {0.39, 0.04});
  trip.Run(90.0);
  EXPECT_LE(trip.Distance_m(), kStop_m + kTolerance_m) << trip.answer.text;
  EXPECT_FALSE(trip.answer.unreachable.has_value());
  EXPECT_GE(trip.nearest_m(), kBody_m);
}

TEST(MapDriveTest, ItDrivesOutOfAUThatItStandsIn) {
  Trip trip({3.0, 0.0});
  trip.AddBlock({0.75, 0.0}, {0.04, 0.55});
  trip.AddBlock({0.15, 0.55}, {0.64, 0.04});
  trip.AddBlock({0.15, -0.55}, {0.64, 0.04});
  trip.Run(90.0);
  EXPECT_LE(trip.Distance_m(), kStop_m + kTolerance_m) << trip.answer.text;
  EXPECT_FALSE(trip.answer.unreachable.has_value());
  EXPECT_GE(trip.nearest_m(), kBody_m);
}

class ClosedInTest : public testing::Test {
 protected:
  ClosedInTest() {
    // A room of its own, large enough to stand in before the target.
    for (const double side : {-1.0, 1.0}) {
      trip_.AddBlock({3.0, side * 1.3}, {1.34, 0.04});
      trip_.AddBlock({3.0 + side * 1.3, 0.0}, {0.04, 1.34});
    }
  }
  Trip trip_{{3.0, 0.0}};
};

TEST_F(ClosedInTest, ATargetThatWallsCloseInIsUnreachableAndWhyIsTold) {
  trip_.Run(200.0);
  ASSERT_TRUE(trip_.answer.unreachable.has_value()) << trip_.answer.text;
  EXPECT_NE(trip_.answer.unreachable->find("obstacles close every way"), std::string::npos)
      << *trip_.answer.unreachable;
  EXPECT_EQ(trip_.answer.velocity.speed_m_s, 0.0);
  EXPECT_EQ(trip_.answer.velocity.turn_rate_rad_s, 0.0);
  EXPECT_GE(trip_.nearest_m(), kBody_m);
}

TEST_F(ClosedInTest, BeforeThatItListensLooksAllRoundAndStepsBack) {
  trip_.Run(200.0);
  ASSERT_TRUE(trip_.answer.unreachable.has_value()) << trip_.answer.text;
  const auto tried = trip_.Tried();
  ASSERT_GE(tried.size(), 3U);
  const auto last = tried.end() - 3;
  EXPECT_NE(last[0].find("listening"), std::string::npos) << last[0];
  EXPECT_NE(last[1].find("looking all round"), std::string::npos) << last[1];
  EXPECT_NE(last[2].find("stepping back"), std::string::npos) << last[2];
}

TEST(MapDriveTest, ImagesOfALampInTheFloorDoNotCloseTheWay) {
  Trip trip({3.0, 0.0});
  for (const double side : {-1.0, 1.0}) {
    trip.AddBlock({3.0, side * 1.3}, {1.34, 0.04});
    trip.AddBlock({3.0 + side * 1.3, 0.0}, {0.04, 1.34}, true);
  }
  trip.Run(200.0);
  EXPECT_FALSE(trip.answer.unreachable.has_value()) << *trip.answer.unreachable;
  EXPECT_LE(trip.Distance_m(), kStop_m + kTolerance_m);
  ASSERT_GE(trip.Tried().size(), 1U);
  EXPECT_NE(trip.Tried()[0].find("listening"), std::string::npos) << "not at the first sight";
  EXPECT_LE(trip.fastest_in_image_m_s, 0.11);
}

TEST_F(ClosedInTest, ItStaysUnreachableUntilRestStartsAnew) {
  trip_.Run(200.0);
  ASSERT_TRUE(trip_.answer.unreachable.has_value()) << trip_.answer.text;
  for (int i = 0; i < 20; ++i) {
    trip_.Step();
    EXPECT_TRUE(trip_.answer.unreachable.has_value());
  }
  trip_.drive.Rest();
  trip_.Step();
  EXPECT_FALSE(trip_.answer.unreachable.has_value());
}

TEST(MapDriveTest, WhatMayBeAMistakeIsForgottenAfterListeningAndBeforeLookingRound) {
  Trip trip({3.0, 0.0});
  for (const double side : {-1.0, 1.0}) {  // the robot is closed in: it soon knows no way
    trip.AddBlock({0.0, side * 0.8}, {0.84, 0.04});
    trip.AddBlock({side * 0.8, 0.0}, {0.04, 0.84});
  }
  trip.Step();
  // Seen once, where the walls do not let it look again.
  const Vector2d doubtful_W_m(-1.5, 0.02);
  navigation::FloorColumn column;
  column.begin_R_m = doubtful_W_m + Vector2d(0.05, 0.0);
  column.end_R_m = doubtful_W_m;
  column.obstacle = true;
  sensor::Image picture;
  picture.utime = MicrosecondsFromSeconds(trip.now_s());
  trip.senses.TakeFloorImage(trip.now_s(), picture, FloorSighting{{}, {}, {column}});
  trip.senses.Look(trip.now_s());
  const auto is_known = [&] {
    const navigation::OccupancyGrid& map = *trip.senses.map();
    return map.ObstacleIn(map.CellAt(doubtful_W_m)).has_value();
  };
  ASSERT_TRUE(is_known());
  bool known_listening = false, known_looking = false;
  for (int i = 0; i < 2000 && !trip.answer.unreachable; ++i) {
    trip.Step();
    if (trip.answer.text.find("listening") != std::string::npos) known_listening |= is_known();
    if (trip.answer.text.find("looking") != std::string::npos) known_looking |= is_known();
  }
  EXPECT_TRUE(trip.answer.unreachable.has_value());
  EXPECT_TRUE(known_listening);
  EXPECT_FALSE(known_looking);
  EXPECT_GE(trip.nearest_m(), kBody_m);
}

TEST(MapDriveTest, WhereItForgotItCreepsAtFirst) {
  Trip trip({4.0, 0.0});
  trip.stuck = true;
  trip.RunUntil([&] { return trip.answer.text.find("looking") != std::string::npos; }, 30.0);
  trip.stuck = false;
  const Vector2d here_W_m = trip.pose.head<2>();
  double fastest_here_m_s = 0.0, fastest_m_s = 0.0;
  trip.RunUntil(
      [&] {
        const double away_m = (trip.pose.head<2>() - here_W_m).norm();
        double& fastest = away_m < 0.4 ? fastest_here_m_s : fastest_m_s;
        fastest = std::max(fastest, trip.answer.velocity.speed_m_s);
        return trip.Distance_m() <= kStop_m + kTolerance_m;
      },
      60.0);
  EXPECT_LE(fastest_here_m_s, 0.1 + 1e-9);
  EXPECT_GT(fastest_m_s, 0.3);
}

TEST(MapDriveTest, WhereAnErrorOfTheMapWouldMeanAContactItCreeps) {
  for (const auto& [half_m, creeps] : {std::pair(0.32, true), {0.42, false}}) {
    SCOPED_TRACE(half_m);
    Trip trip = Trip::ToDestination({3.2, 0.0});
    for (const double side : {-1.0, 1.0}) {  // a passage
      trip.AddBlock({1.5, side * (half_m + 2.0)}, {0.3, 2.0});
    }
    double fastest_inside_m_s = 0.0;
    trip.RunUntil(
        [&] {
          const bool inside = std::abs(trip.pose.x() - 1.5) < 0.2;
          if (inside) {
            fastest_inside_m_s = std::max(fastest_inside_m_s, trip.answer.velocity.speed_m_s);
          }
          return trip.Distance_m() <= 0.1;
        },
        60.0);
    EXPECT_LE(trip.Distance_m(), 0.1) << trip.answer.text;
    EXPECT_GE(trip.nearest_m(), kBody_m);
    EXPECT_EQ(fastest_inside_m_s <= 0.1 + 1e-9, creeps) << fastest_inside_m_s;
  }
}

TEST(MapDriveTest, ARobotThatDoesNotMoveTriesEverythingAndThenSaysSo) {
  Trip trip({3.0, 0.0});
  trip.stuck = true;
  trip.Run(120.0);
  ASSERT_TRUE(trip.answer.unreachable.has_value()) << trip.answer.text;
  EXPECT_NE(trip.answer.unreachable->find("comes no nearer"), std::string::npos)
      << *trip.answer.unreachable;
  const auto tried = trip.Tried();
  ASSERT_EQ(tried.size(), 3U);
  EXPECT_NE(tried[0].find("listening"), std::string::npos) << tried[0];
  EXPECT_NE(tried[1].find("looking all round"), std::string::npos) << tried[1];
  EXPECT_NE(tried[2].find("stepping back"), std::string::npos) << tried[2];
}

TEST(MapDriveTest, ToAPlaceItDrivesOntoIt) {
  for (const Vector2d& place_m : {Vector2d(1.5, 0.4), Vector2d(-1.2, -0.9)}) {
    SCOPED_TRACE(place_m.transpose());
    Trip trip = Trip::ToPlace(place_m);
    trip.AddBlock(0.5 * place_m, {0.1, 0.1});  // in the way
    trip.Run(60.0, 0.1);
    EXPECT_LE(trip.Distance_m(), 0.1) << trip.answer.text;
    EXPECT_FALSE(trip.answer.unreachable.has_value());
    EXPECT_GE(trip.nearest_m(), kBody_m);
  }
}

TEST(MapDriveTest, OnADestinationItInsistsAsOnATarget) {
  Trip trip = Trip::ToDestination({3.0, 0.0});
  for (const double side : {-1.0, 1.0}) {  // the robot is closed in
    trip.AddBlock({0.0, side * 0.8}, {0.84, 0.04});
    trip.AddBlock({side * 0.8, 0.0}, {0.04, 0.84});
  }
  trip.RunUntil([] { return false; }, 120.0);
  ASSERT_TRUE(trip.answer.unreachable.has_value()) << trip.answer.text;
  EXPECT_NE(trip.answer.unreachable->find("every way to the place"), std::string::npos)
      << *trip.answer.unreachable;
  ASSERT_FALSE(trip.Tried().empty());
  EXPECT_NE(trip.Tried().back().find("stepping back"), std::string::npos);
}

TEST(MapDriveTest, OfTwoGapsItTakesTheOneThatIsSureToStayOpen) {
  // Gaps that the map shows as open, but the safe polygon does not let the robot pass.
  for (const auto& [off_m, half_m] : {std::pair(0.0, 0.315), {0.1, 0.31}, {0.2, 0.3}}) {
    SCOPED_TRACE(off_m);
    Trip trip = Trip::ToDestination({3.2, 0.0});
    const double x_m = 1.5, before_m = x_m - 0.5 * off_m, behind_m = x_m + 0.5 * off_m;
    trip.AddBlock({before_m, -half_m - 2.0}, {0.02, 2.0});
    trip.AddBlock({behind_m, half_m + 0.5}, {0.02, 0.5});
    trip.AddBlock({behind_m, half_m + 3.0}, {0.02, 1.0});  // beside the wider one
    trip.Run(60.0, 0.1);
    EXPECT_LE(trip.Distance_m(), 0.1) << trip.answer.text << trip.answer.unreachable.value_or("");
    EXPECT_GE(trip.nearest_m(), kBody_m);
    EXPECT_TRUE(trip.Tried().empty()) << trip.Tried().front();
  }
}

TEST(MapDriveTest, RoundATargetItDrivesToTheSideThatIsAskedFor) {
  for (const double side_rad : {1.6, -1.6, 0.0, 2.6}) {
    SCOPED_TRACE(side_rad);
    Trip trip = Trip::RoundTarget({2.0, 0.0}, side_rad);
    const auto is_there = [&] {
      return trip.Distance_m() <= kStop_m + kTolerance_m &&
             std::abs(WrapAngle(trip.Bearing_rad() - side_rad)) < 0.35;
    };
    trip.RunUntil(is_there, 90.0);
    EXPECT_TRUE(is_there()) << trip.Bearing_rad() << " " << trip.answer.text;
    EXPECT_FALSE(trip.answer.unreachable.has_value());
    EXPECT_GE(trip.nearest_m(), kBody_m) << "not through the target";
  }
}

TEST(MapDriveTest, APlaceAndASideAreGivenUpWithoutLookingRoundOrSteppingBack) {
  for (const bool side : {false, true}) {
    SCOPED_TRACE(side);
    Trip trip = side ? Trip::RoundTarget({2.2, 0.0}, 0.0) : Trip::ToPlace({2.2, 0.0});
    for (const double way : {-1.0, 1.0}) {  // a room round it, too small for the robot's way out
      trip.AddBlock({2.2, way * 1.25}, {1.29, 0.04});
      trip.AddBlock({2.2 + way * 1.25, 0.0}, {0.04, 1.29});
    }
    trip.RunUntil([] { return false; }, 120.0);
    ASSERT_TRUE(trip.answer.unreachable.has_value()) << trip.answer.text;
    for (const std::string& tried : trip.Tried()) {
      EXPECT_NE(tried.find("listening"), std::string::npos) << tried;
    }
    EXPECT_GE(trip.nearest_m(), kBody_m);
  }
}

}  // namespace
}  // namespace geon::mission
