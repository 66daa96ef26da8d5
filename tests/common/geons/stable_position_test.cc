#include "geons/stable_position.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace geon::geons {
namespace {

GeonShape Shape(GeonLabel label, int position) {
  return {
      label, {0.1, 0.1, 0.2}, IsTapered(label) ? 0.5 : 0.0, IsBent(label) ? 1.5 : 0.0, position};
}

TEST(StablePosition, IsAlwaysAProperRotation) {
  for (int l = 0; l < kGeonLabelCount; ++l) {
    const auto label = static_cast<GeonLabel>(l);
    for (int position = 1; position <= StablePositionCount(label); ++position) {
      const Eigen::Matrix3d R = StablePositionRotation(Shape(label, position));
      EXPECT_NEAR((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12);
      EXPECT_NEAR(R.row(0).cross(R.row(1)).dot(R.row(2)), 1.0, 1e-12);
    }
  }
}

TEST(StablePosition, AnInvertedGeonStandsOnItsHead) {
  const Eigen::Matrix3d R = StablePositionRotation(Shape(GeonLabel::kTaperedCylinder, 3));
  EXPECT_NEAR((R * Eigen::Vector3d::UnitZ()).z(), -1.0, 1e-12);
}

TEST(StablePosition, ALyingTaperedGeonLeansByItsFlank) {
  const Eigen::Matrix3d R = StablePositionRotation(Shape(GeonLabel::kTaperedCuboid, 2));
  // From 0.10 to 0.033 m over a height of 0.2 m: each flank leans by 0.033 in 0.2.
  EXPECT_NEAR((R * Eigen::Vector3d::UnitZ()).z(), -std::sin(std::atan((0.1 - 0.1 / 3) / 0.4)),
              1e-12);
}

TEST(StablePosition, TheArchOpensDownwardAndItsContraryUpward) {
  // The centre of curvature is on the +x side of a bent geon.
  const Eigen::Vector3d inside = Eigen::Vector3d::UnitX();
  EXPECT_LT((StablePositionRotation(Shape(GeonLabel::kBentCuboid, 2)) * inside).z(), -0.99);
  EXPECT_GT((StablePositionRotation(Shape(GeonLabel::kBentCuboid, 3)) * inside).z(), 0.99);
  EXPECT_NEAR((StablePositionRotation(Shape(GeonLabel::kBentCuboid, 1)) * inside).z(), 0.0, 1e-12);
}

}  // namespace
}  // namespace geon::geons
