#include "active_vision/surface_distance.h"

#include <gtest/gtest.h>

#include "tests/common/active_vision/test_rig.h"

namespace geon::active_vision {
namespace {

using sensor::Laser;

// A wall across the line of sight that is nearer on its left half, measured by one horizontal
// stripe.
class SurfaceDistanceTest : public testing::Test {
 protected:
  SurfaceDistanceTest() {
    sensor::RangeProfile profile;
    for (int k = -60; k <= 60; ++k) {
      const double y_m = 0.001 * k;
      profile.pixel.push_back(k + 100);
      profile.p_L_m.emplace_back(y_m > 0.0 ? 0.95 : 1.05, y_m, height_m_);
    }
    measured_.push_back(profile);
    // The box around the points as the colour camera sees them.
    const auto X_RB = rig_.StripeCameraPose(head_.pan_rad, head_.tilt_rad);
    const auto X_CL = rig_.ColorCameraPose(head_.pan_rad, head_.tilt_rad).inverse() *
                      geometry::LevelFrame(X_RB, 0.0);
    const auto left = rig_.color_camera.Project(X_CL * profile.p_L_m.back());
    const auto right = rig_.color_camera.Project(X_CL * profile.p_L_m.front());
    target_.box = {static_cast<int>(left.x()) - 5, static_cast<int>(left.y()) - 100,
                   static_cast<int>(right.x() - left.x()) + 10, 200};
    target_.head = head_;
    target_.distance_m = 1.0;
  }
  std::optional<double> At(Laser laser, double fraction) const {
    return SurfaceDistance(rig_, target_, 0.0, measured_, laser, fraction);
  }

  const geometry::SensorRig rig_ = TestRig();
  const HeadAngles head_{0.0, -0.5};
  const double height_m_ = 0.1;
  StripeTarget target_;
  std::vector<sensor::RangeProfile> measured_;
};

TEST_F(SurfaceDistanceTest, TellsTheDepthWhereAVerticalStripeWillCut) {
  EXPECT_NEAR(At(Laser::kVertical, 0.25).value(), 0.95, 1e-12);
  EXPECT_NEAR(At(Laser::kVertical, 0.75).value(), 1.05, 1e-12);
}

TEST_F(SurfaceDistanceTest, NothingWithoutPointsOnTheTarget) {
  for (Eigen::Vector3d& p_m : measured_[0].p_L_m) p_m.y() += 0.5;
  EXPECT_FALSE(At(Laser::kVertical, 0.5).has_value());
  measured_.clear();
  EXPECT_FALSE(At(Laser::kHorizontal, 0.5).has_value());
}

}  // namespace
}  // namespace geon::active_vision
