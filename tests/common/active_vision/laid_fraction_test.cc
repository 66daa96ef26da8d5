#include "active_vision/laid_fraction.h"

#include <gtest/gtest.h>

#include "tests/common/active_vision/test_rig.h"

namespace geon::active_vision {
namespace {

// A wall 1 m ahead, cut by an upright plane; the colour camera sees it 0.2 m above the support.
class LaidFractionTest : public testing::Test {
 protected:
  LaidFractionTest() {
    profile_.laser = sensor::Laser::kVertical;
    for (int k = 0; k < 100; ++k) profile_.p_L_m.emplace_back(1.0, 0.02, 0.15 + 0.001 * k);
    X_CL_.linear() = geometry::CameraAxesInBody().transpose();
    X_CL_.translation() = -(X_CL_.linear() * Eigen::Vector3d(0.0, 0.0, 0.2));
  }
  std::optional<double> Laid() const {
    return LaidFraction(profile_, X_CL_, camera_, {220, 140, 200, 200});
  }
  const geometry::PinholeCamera camera_;
  geometry::RigidTransform X_CL_ = geometry::RigidTransform::Identity();
  sensor::RangeProfile profile_;
};

TEST_F(LaidFractionTest, IsThePartOfTheBoxToTheStripe) {
  // 20 mm left of the axis at 1 m: 32 of 200 pixels left of the middle.
  EXPECT_NEAR(Laid().value(), 0.5 - 32.0 / 200.0, 1e-9);
  profile_.laser = sensor::Laser::kHorizontal;
  for (int k = 0; k < 100; ++k) profile_.p_L_m[k] = {1.0, 0.001 * (k - 50), 0.21};
  EXPECT_NEAR(Laid().value(), 0.5 - 16.0 / 200.0, 1e-9);
}

TEST_F(LaidFractionTest, WhatLiesOnTheSupportOrOutsideTheBoxTellsNothing) {
  for (Eigen::Vector3d& p_m : profile_.p_L_m) p_m.y() = 0.2;
  EXPECT_FALSE(Laid().has_value());
  for (Eigen::Vector3d& p_m : profile_.p_L_m) p_m = {1.0, 0.0, 0.005};
  EXPECT_FALSE(Laid().has_value());
  profile_.p_L_m.clear();
  EXPECT_FALSE(Laid().has_value());
}

}  // namespace
}  // namespace geon::active_vision
