#include "navigation/velocity_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace geon::navigation {
namespace {

using Eigen::Vector2d;

constexpr double kStep_s = 0.05;

TEST(FreeTravelTest, CountsFromTheSkinOfTheBody) {
  const VelocityLawOptions options;
  const std::vector<Vector2d> ahead = {{1.0, 0.0}};
  EXPECT_NEAR(FreeTravel(ahead, 1.0, options), 1.0 - 0.267 - options.front_margin_m, 1e-9);
  EXPECT_TRUE(std::isinf(FreeTravel(ahead, -1.0, options)));
  const std::vector<Vector2d> beside = {{1.0, 0.30}, {1.0, -0.30}, {-1.0, 0.0}};
  EXPECT_TRUE(std::isinf(FreeTravel(beside, 1.0, options)));
}

TEST(VelocityLawTest, TurnsOnTheSpotFirst) {
  const DriveVelocity velocity = DriveTo({0.0, 1.0}, {}, 0.0, kStep_s, {});
  EXPECT_EQ(velocity.speed_m_s, 0.0);
  EXPECT_GT(velocity.turn_rate_rad_s, 0.5);
}

TEST(VelocityLawTest, SpeedsUpGently) {
  const VelocityLawOptions options;
  const DriveVelocity velocity = DriveTo({2.0, 0.0}, {}, 0.1, kStep_s, options);
  EXPECT_NEAR(velocity.speed_m_s, 0.1 + options.acceleration_m_s2 * kStep_s, 1e-12);
}

TEST(VelocityLawTest, StoppingSpeedLeavesRoomForReactionAndBraking) {
  const VelocityLawOptions options;
  for (const double distance_m : {0.01, 0.05, 0.2, 0.5}) {
    const double v_m_s = StoppingSpeed(distance_m, options);
    EXPECT_LE(v_m_s * options.reaction_s + v_m_s * v_m_s / (2.0 * options.deceleration_m_s2),
              distance_m + 1e-12);
  }
  EXPECT_EQ(StoppingSpeed(-1.0, options), 0.0);
  EXPECT_EQ(StoppingSpeed(100.0, options), options.max_speed_m_s);
}

TEST(VelocityLawTest, ArrivingSpeedBrakesAsGentlyAsItSpeedsUp) {
  const VelocityLawOptions options;
  for (const double distance_m : {0.01, 0.05, 0.2, 0.5}) {
    const double v_m_s = ArrivingSpeed(distance_m, options);
    EXPECT_NEAR(v_m_s * v_m_s / (2.0 * options.acceleration_m_s2), distance_m, 1e-12);
    EXPECT_GT(v_m_s, StoppingSpeed(std::min(distance_m, 0.2), options));
  }
  EXPECT_EQ(ArrivingSpeed(-1.0, options), 0.0);
}

// A disc that obeys each command one reaction time late must never touch a point it knows of.
TEST(VelocityLawTest, NeverTouchesAPointAheadDespiteTheDelay) {
  const VelocityLawOptions options;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> lateral_m(-0.4, 0.4);
  for (int round = 0; round < 100; ++round) {
    const Vector2d obstacle_W_m(2.0, lateral_m(random));
    double x_m = 0.0;
    double speed_m_s = 0.0;
    std::vector<double> delayed_m_s(static_cast<size_t>(options.reaction_s / kStep_s), 0.0);
    for (int step = 0; step < 200; ++step) {
      const std::vector<Vector2d> obstacles_R_m = {obstacle_W_m - Vector2d(x_m, 0.0)};
      const DriveVelocity velocity =
          DriveTo({3.0 - x_m, 0.0}, obstacles_R_m, speed_m_s, kStep_s, options);
      delayed_m_s.push_back(velocity.speed_m_s);
      speed_m_s = velocity.speed_m_s;
      x_m += delayed_m_s[static_cast<size_t>(step)] * kStep_s;
      ASSERT_GT((obstacle_W_m - Vector2d(x_m, 0.0)).norm(), options.body_radius_m)
          << "round " << round << " step " << step;
    }
  }
}

TEST(VelocityLawTest, BacksOffSlowlyAndNotIntoThings) {
  const VelocityLawOptions options;
  EXPECT_NEAR(Creep(-1.0, 0.5, 0.1, {}, options).speed_m_s, -0.1, 1e-12);
  const std::vector<Vector2d> behind = {{-0.30, 0.0}};
  EXPECT_EQ(Creep(-1.0, 0.5, 0.1, behind, options).speed_m_s, 0.0);
}

TEST(VelocityLawTest, CommandsStayWithinTheLimits) {
  const VelocityLawOptions options;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> coordinate_m(-4.0, 4.0);
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Vector2d> obstacles = {{coordinate_m(random), coordinate_m(random)}};
    const DriveVelocity velocity = DriveTo({coordinate_m(random), coordinate_m(random)}, obstacles,
                                           std::abs(coordinate_m(random)), kStep_s, options);
    EXPECT_GE(velocity.speed_m_s, 0.0);
    EXPECT_LE(velocity.speed_m_s, options.max_speed_m_s);
    EXPECT_LE(std::abs(velocity.turn_rate_rad_s), options.max_turn_rate_rad_s);
  }
}

}  // namespace
}  // namespace geon::navigation
