#include "sim/infrared_ring.h"

#include <gtest/gtest.h>

#include "tests/common/sim/device_testing.h"

namespace geon::sim {
namespace {

int Ahead(double away_m, double reflectance_1) {
  const Walls world({{{-1.0, 0.0}, -(away_m + 0.225)}}, reflectance_1);
  InfraredRing ring({}, 1, &world);
  ring.Advance(0.0, {});
  return ring.levels()[0];
}

TEST(InfraredRing, ReadsMoreTheNearerAndTheBrighter) {
  EXPECT_GE(Ahead(0.01, 0.8), 14);
  EXPECT_GT(Ahead(0.1, 0.8), Ahead(0.3, 0.8));
  EXPECT_GT(Ahead(0.15, 0.8), Ahead(0.15, 0.2));
  EXPECT_EQ(Ahead(0.7, 0.8), 0);
}

TEST(InfraredRing, OnlySensorsInTheOrderRead) {
  const Walls world({{{-1.0, 0.0}, -0.3}});
  InfraredRing ring({}, 1, &world);
  ring.Configure(0, {1, 15, 255, 0});
  ring.Advance(0.0, {});
  EXPECT_EQ(ring.levels()[0], 0);
  EXPECT_GT(ring.levels()[1], 0);
}

TEST(InfraredRing, HistoryMakesItSlow) {
  const Walls world({{{-1.0, 0.0}, -0.26}});
  InfraredRing ring({}, 1, &world);
  ring.Configure(9, {0});
  RingPose pose;
  ring.Advance(0.0, pose);
  EXPECT_LE(ring.levels()[0], 2);
  for (int i = 1; i < 60; ++i) ring.Advance(i * 0.051, pose);
  EXPECT_GE(ring.levels()[0], 13);
}

}  // namespace
}  // namespace geon::sim
