#include "sim/mounting.h"

#include <gtest/gtest.h>

#include "base/angles.h"

namespace geon::sim {
namespace {

geometry::SensorRig Mounted(int individual, MountingErrorOptions options = {}) {
  options.individual = individual;
  return AsMounted(geometry::SensorRig{}, options);
}

TEST(MountingTest, AnIndividualKeepsItsErrorsAndNoTwoAreAlike) {
  const geometry::SensorRig first = Mounted(1);
  EXPECT_EQ(first.stripe_camera.fx_px, Mounted(1).stripe_camera.fx_px);
  EXPECT_EQ(first.horizontal_laser.normal_T, Mounted(1).horizontal_laser.normal_T);
  EXPECT_NE(first.stripe_camera.fx_px, Mounted(2).stripe_camera.fx_px);
  EXPECT_NE(first.horizontal_laser.normal_T, Mounted(2).horizontal_laser.normal_T);
}

TEST(MountingTest, ErrorsAreOfTheStatedSize) {
  const geometry::SensorRig designed;
  double focal_1 = 0.0, laser_rad = 0.0;
  const int count = 500;
  for (int individual = 0; individual < count; ++individual) {
    const geometry::SensorRig rig = Mounted(individual);
    const double scale = rig.stripe_camera.fx_px / designed.stripe_camera.fx_px - 1.0;
    focal_1 += scale * scale / count;
    // Two of the three components of the small turn move the normal.
    const double angle_rad =
        std::acos(std::min(1.0, rig.vertical_laser.normal_T.dot(designed.vertical_laser.normal_T)));
    laser_rad += angle_rad * angle_rad / (2.0 * count);
  }
  EXPECT_NEAR(std::sqrt(focal_1), 0.003, 0.0003);
  EXPECT_NEAR(std::sqrt(laser_rad), RadiansFromDegrees(0.3), RadiansFromDegrees(0.03));
}

TEST(MountingTest, NoErrorsLeaveTheDesign) {
  const geometry::SensorRig rig = Mounted(1, {0.0, 0.0, 0.0});
  EXPECT_TRUE(rig.X_TB.isApprox(geometry::SensorRig{}.X_TB));
  EXPECT_EQ(rig.stripe_camera.fx_px, 1600.0);
}

}  // namespace
}  // namespace geon::sim
