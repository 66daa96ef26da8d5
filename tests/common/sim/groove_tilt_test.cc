#include "sim/groove_tilt.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"

namespace geon::sim {
namespace {

double TiltOf(const Eigen::Matrix3d& rotation) { return std::acos(std::min(1.0, rotation(2, 2))); }

TEST(GrooveTiltTest, FlatFloorDoesNotTilt) {
  EXPECT_TRUE(GrooveTilt({}, {1.2, 0.6}, 0.3).isIdentity());
}

TEST(GrooveTiltTest, OneWheelInAGrooveTiltsByTheStatedAngleTowardsIt) {
  const FloorGrooves grooves{0.6, RadiansFromDegrees(1.0)};
  // Wheel 0 ahead along x stands on the groove x = 0.6; the other two are in the middle of a tile.
  const Eigen::Vector2d center_m(0.6 - 0.19, 0.3);
  const Eigen::Matrix3d tilt = GrooveTilt(grooves, center_m, 0.0);
  EXPECT_NEAR(TiltOf(tilt), RadiansFromDegrees(1.0), 1e-4);
  EXPECT_LT((tilt * Eigen::Vector3d::UnitX()).z(), 0.0);  // nose down
}

TEST(GrooveTiltTest, NoWheelInAGrooveLeavesItLevel) {
  const FloorGrooves grooves{0.6, RadiansFromDegrees(1.0)};
  EXPECT_NEAR(TiltOf(GrooveTilt(grooves, {0.3, 0.3}, 0.0)), 0.0, 1e-9);
}

}  // namespace
}  // namespace geon::sim
