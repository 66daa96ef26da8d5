#include "navigation/ring_obstacles.h"

#include <gtest/gtest.h>

#include <limits>

namespace geon::navigation {
namespace {

sensor::SonarScan Silence() {
  sensor::SonarScan scan;
  scan.range_m.fill(std::numeric_limits<double>::quiet_NaN());
  return scan;
}

TEST(SonarObstaclesTest, AnEchoLiesOnItsSensorsAxisFromTheRingOutward) {
  sensor::SonarScan scan = Silence();
  scan.range_m[4] = 1.0;  // 90 degrees to the left
  const auto points = SonarObstacles(scan, {});
  ASSERT_EQ(points.size(), 1u);
  EXPECT_NEAR(points[0].x(), 0.0, 1e-12);
  EXPECT_NEAR(points[0].y(), 1.225, 1e-12);
}

TEST(SonarObstaclesTest, NoEchoAndFarEchoesGiveNoPoint) {
  sensor::SonarScan scan = Silence();
  scan.range_m[0] = 6.477;
  EXPECT_TRUE(SonarObstacles(scan, {}).empty());
}

TEST(SonarObstaclesTest, InsideTheBlankingDistanceSomethingIsThere) {
  sensor::SonarScan scan = Silence();
  scan.range_m[0] = 0.4318;  // 17 inches, the nearest the ring reports
  const auto points = SonarObstacles(scan, {});
  ASSERT_EQ(points.size(), 1u);
  EXPECT_NEAR(points[0].x(), 0.225 + 0.44, 1e-12);
}

TEST(InfraredObstaclesTest, TouchingIsAtTheSkinAndWeakIsNothing) {
  sensor::InfraredScan scan;
  scan.level[8] = 15;
  scan.level[0] = 2;
  const auto points = InfraredObstacles(scan, {});
  ASSERT_EQ(points.size(), 1u);
  EXPECT_NEAR(points[0].x(), -0.267, 1e-12);
}

TEST(InfraredObstaclesTest, TheLevelFallsFastFromTheSkinOn) {
  const auto distance = [](int level) {
    sensor::InfraredScan scan;
    scan.level[0] = level;
    return InfraredObstacles(scan, {})[0].x() - 0.267;
  };
  EXPECT_NEAR(distance(5), 0.6 * 4.0 / 9.0, 1e-9);
  EXPECT_LT(distance(10), 0.5 * distance(7));
}

}  // namespace
}  // namespace geon::navigation
