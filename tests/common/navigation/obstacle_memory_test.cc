#include "navigation/obstacle_memory.h"

#include <gtest/gtest.h>

namespace geon::navigation {
namespace {

using Eigen::Vector2d;

// A fan of columns ahead: floor from 0.35 m up to `end_m`.
std::vector<FloorColumn> Fan(double end_m, bool obstacle) {
  std::vector<FloorColumn> columns;
  for (int i = 40; i >= -40; --i) {
    const Vector2d direction(std::cos(0.02 * i), std::sin(0.02 * i));
    columns.push_back({0.35 * direction, end_m * direction, obstacle});
  }
  return columns;
}

std::vector<Vector2d> Seen(const ObstacleMemory& memory, const geometry::RigidTransform& X_WR) {
  std::vector<Vector2d> points_R_m;
  memory.In(X_WR.inverse(), &points_R_m);
  return points_R_m;
}

TEST(ObstacleMemoryTest, KeepsWhatTheCameraNoLongerSees) {
  ObstacleMemory memory({});
  const auto start = geometry::PlanarPose(0.0, 0.0, 0.0);
  memory.SeeFloor(0.0, start, Fan(1.0, true));
  const auto turned = geometry::PlanarPose(0.0, 0.0, M_PI);
  memory.SeeFloor(1.0, turned, Fan(2.5, false));
  const auto points = Seen(memory, turned);
  ASSERT_FALSE(points.empty());
  for (const Vector2d& p_m : points) EXPECT_LT(p_m.x(), -0.5);
}

TEST(ObstacleMemoryTest, FloorSeenWhereAPointWasDisprovesIt) {
  ObstacleMemory memory({});
  const auto pose = geometry::PlanarPose(0.0, 0.0, 0.0);
  memory.SeeFloor(0.0, pose, Fan(1.0, true));
  memory.SeeFloor(0.1, pose, Fan(2.5, false));
  for (const Vector2d& p_m : Seen(memory, pose)) {
    EXPECT_GT(std::abs(std::atan2(p_m.y(), p_m.x())), 0.75);  // only the rim of the picture remains
  }
}

TEST(ObstacleMemoryTest, WhatIsBelowThePictureIsNotDisproved) {
  ObstacleMemory memory({});
  memory.SeeFloor(0.0, geometry::PlanarPose(0.0, 0.0, 0.0), Fan(0.6, true));
  const auto nearer = geometry::PlanarPose(0.3, 0.0, 0.0);  // the point is 0.30 m ahead now
  memory.SeeFloor(1.0, nearer, Fan(2.5, false));
  bool kept = false;
  for (const Vector2d& p_m : Seen(memory, nearer))
    kept = kept || (p_m - Vector2d(0.3, 0)).norm() < 0.06;
  EXPECT_TRUE(kept);
}

TEST(ObstacleMemoryTest, EchoesFadeAndTheCameraDoesNotDisproveThem) {
  ObstacleMemoryOptions options;
  ObstacleMemory memory(options);
  const auto pose = geometry::PlanarPose(1.0, 2.0, 0.5);
  const std::vector<Vector2d> echo = {{0.9, 0.0}};
  memory.Feel(0.0, pose, echo);
  memory.SeeFloor(0.5, pose, Fan(2.5, false));
  ASSERT_EQ(Seen(memory, pose).size(), 1u);
  EXPECT_NEAR((Seen(memory, pose)[0] - echo[0]).norm(), 0.0, 1e-9);
  memory.Forget(options.sonar_memory_s + 0.1);
  EXPECT_TRUE(Seen(memory, pose).empty());
}

TEST(ObstacleMemoryTest, OnePointPerCellHoweverOftenItIsSeen) {
  ObstacleMemory memory({});
  const auto pose = geometry::PlanarPose(0.0, 0.0, 0.0);
  for (int i = 0; i < 50; ++i) memory.SeeFloor(0.1 * i, pose, Fan(1.0, true));
  EXPECT_LT(Seen(memory, pose).size(), 60u);
}

}  // namespace
}  // namespace geon::navigation
