#include "mission/map_drive.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/angles.h"
#include "base/time.h"
#include "tests/common/mission/fake_world.h"

namespace geon::mission {
namespace {

using Eigen::Vector2d;

constexpr double kBody_m = 0.267;
constexpr double kStop_m = 0.93;
constexpr double kTolerance_m = 0.04;  // with which a mission takes the place as reached

struct Wall {
  Vector2d from_W_m, to_W_m;
  bool lamp = false;  // its image in the floor: bright, and nothing to bump into
};

// How far along a ray a wall is; infinite when the ray passes by.
double Along(const Vector2d& from_m, const Vector2d& direction, const Wall& wall) {
  const Vector2d edge_m = wall.to_W_m - wall.from_W_m, to_wall_m = wall.from_W_m - from_m;
  const auto cross = [](const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  const double slant = cross(direction, edge_m);
  if (std::abs(slant) < 1e-12) return std::numeric_limits<double>::infinity();
  const double share_1 = cross(to_wall_m, direction) / slant;
  const double along_m = cross(to_wall_m, edge_m) / slant;
  return share_1 < 0.0 || share_1 > 1.0 || along_m < 0.0 ? std::numeric_limits<double>::infinity()
                                                         : along_m;
}

double Distance(const Vector2d& p_m, const Wall& wall) {
  const Vector2d edge_m = wall.to_W_m - wall.from_W_m;
  const double share_1 = (p_m - wall.from_W_m).dot(edge_m) / edge_m.squaredNorm();
  return (wall.from_W_m + std::clamp(share_1, 0.0, 1.0) * edge_m - p_m).norm();
}

// A robot that drives as it is told and sees the floor before it up to the walls; nothing else.
class Trip {
 public:
  explicit Trip(const Vector2d& target_W_m) : Trip(target_W_m, Way::kToward, 0.0) {}
  // To a place on the floor, where nothing stands.
  static Trip ToPlace(const Vector2d& place_W_m) { return {place_W_m, Way::kTo, 0.0}; }
  // Round a target to this side of it.
  static Trip RoundTarget(const Vector2d& target_W_m, double side_rad) {
    return {target_W_m, Way::kRound, side_rad};
  }

  void AddBlock(const Vector2d& middle_m, const Vector2d& half_m, bool lamp = false) {
    const Vector2d other_m(half_m.x(), -half_m.y());
    const Vector2d corners_m[] = {middle_m - half_m, middle_m + other_m, middle_m + half_m,
                                  middle_m - other_m};
    for (int k = 0; k < 4; ++k) walls_.push_back({corners_m[k], corners_m[(k + 1) % 4], lamp});
  }

  // Until `done`, it is said that it cannot be reached, or the time is over.
  template <typename Done>
  void RunUntil(Done done, double limit_s) {
    const double end_s = now_s_ + limit_s;
    while (now_s_ < end_s && !done() && !answer.unreachable) Step();
  }
  // Until the target is so near, it is said that it cannot be reached, or the time is over.
  void Run(double limit_s, double near_m = kStop_m + kTolerance_m) {
    RunUntil([&] { return Distance_m() <= near_m; }, limit_s);
  }
  void Step() {
    constexpr double kTick_s = 0.05;
    now_s_ += kTick_s;
    Move(kTick_s);
    sensor::BaseState base;
    base.utime = MicrosecondsFromSeconds(now_s_);
    base.status = sensor::DeviceStatus::kReady;
    base.x_m = pose.x();
    base.y_m = pose.y();
    base.heading_rad = pose.z();
    senses.Take(now_s_, base);
    if (step_++ % 4 == 0) {
      sensor::Image picture;
      picture.utime = base.utime;
      senses.TakeFloorImage(now_s_, picture, FloorSighting{{}, {}, Columns()});
    }
    senses.Look(now_s_);
    answer = Drive();
    if (!answer.text.empty() && (texts.empty() || texts.back() != answer.text)) {
      texts.push_back(answer.text);
    }
  }
  double now_s() const { return now_s_; }
  // In W, from the target to the robot.
  double Bearing_rad() const {
    const Vector2d out_m = pose.head<2>() - target_W_m_;
    return std::atan2(out_m.y(), out_m.x());
  }
  double Distance_m() const { return (pose.head<2>() - target_W_m_).norm(); }
  // Since the start, from the robot's axis to the nearest wall.
  double nearest_m() const { return nearest_m_; }
  // What was tried to come nearer, in its order.
  std::vector<std::string> Tried() const {
    std::vector<std::string> tried;
    std::copy_if(texts.begin(), texts.end(), std::back_inserter(tried),
                 [](const std::string& text) { return text.starts_with("no nearer"); });
    return tried;
  }

  Eigen::Vector3d pose{0.0, 0.0, 0.0};  // x, y, heading
  bool stuck = false;                   // nothing moves it
  Senses senses{FastOptions(), SmallRig()};
  MapDrive drive{FastOptions()};
  MapDrive::Answer answer;
  std::vector<std::string> texts;
  double fastest_in_image_m_s = 0.0;  // onto a lamp's image

 private:
  enum class Way { kToward, kRound, kTo };
  Trip(const Vector2d& goal_W_m, Way way, double side_rad)
      : target_W_m_(goal_W_m), way_(way), side_rad_(side_rad) {
    if (way != Way::kTo) AddBlock(goal_W_m, {0.1, 0.1});
  }
  MapDrive::Answer Drive() {
    switch (way_) {
      case Way::kRound:
        return drive.Round(now_s_, target_W_m_, kStop_m, side_rad_, &senses);
      case Way::kTo:
        return drive.To(now_s_, target_W_m_, &senses);
      case Way::kToward:
        break;
    }
    return drive.Toward(now_s_, target_W_m_, kStop_m, &senses);
  }
  void Move(double step_s) {
    if (stuck) return;
    pose.z() = WrapAngle(pose.z() + answer.velocity.turn_rate_rad_s * step_s);
    pose.head<2>() +=
        answer.velocity.speed_m_s * step_s * Vector2d(std::cos(pose.z()), std::sin(pose.z()));
    for (const Wall& wall : walls_) {
      const double away_m = Distance(pose.head<2>(), wall);
      if (!wall.lamp) nearest_m_ = std::min(nearest_m_, away_m);
      const Vector2d ahead(std::cos(pose.z()), std::sin(pose.z()));
      if (wall.lamp && Along(pose.head<2>(), ahead, wall) < kBody_m) {
        fastest_in_image_m_s = std::max(fastest_in_image_m_s, answer.velocity.speed_m_s);
      }
    }
  }
  std::vector<navigation::FloorColumn> Columns() const {
    constexpr int kColumns = 81;
    constexpr double kHalfFan_rad = 0.9, kBegin_m = 0.32, kRange_m = 2.8;
    std::vector<navigation::FloorColumn> columns;
    for (int k = 0; k < kColumns; ++k) {
      const double bearing_rad = kHalfFan_rad * (1.0 - 2.0 * k / (kColumns - 1));
      const double angle_rad = pose.z() + bearing_rad;
      double free_m = kRange_m;
      bool bright = false;
      for (const Wall& wall : walls_) {
        const double wall_m =
            Along(pose.head<2>(), {std::cos(angle_rad), std::sin(angle_rad)}, wall);
        if (wall_m >= free_m) continue;
        free_m = wall_m;
        bright = wall.lamp;
      }
      const Vector2d along(std::cos(bearing_rad), std::sin(bearing_rad));
      columns.push_back(
          {kBegin_m * along, std::max(kBegin_m, free_m) * along, free_m < kRange_m, bright});
    }
    return columns;
  }

  Vector2d target_W_m_;
  Way way_;
  double side_rad_;
  std::vector<Wall> walls_;
  double now_s_ = 100.0;
  int step_ = 0;
  double nearest_m_ = std::numeric_limits<double>::infinity();
};

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
