#include "recognition/profile_ends.h"

#include <gtest/gtest.h>

#include "geometry/rigid_transform.h"

namespace geon::recognition {
namespace {

const BwCamera kCamera{Eigen::Vector3d(0, 0, 1), geometry::CameraAxesInBody()};

TargetProfile Profile(sensor::Laser laser, double fraction,
                      const std::vector<Eigen::Vector3d>& p_L_m) {
  TargetProfile profile;
  profile.laser = laser;
  profile.fraction = fraction;
  profile.p_L_m = p_L_m;
  if (p_L_m.size() >= 2) profile.segments = {{0, p_L_m.size()}};
  return profile;
}

TEST(FindProfileEnds, GivesCameraCoordinatesByRisingFraction) {
  const std::vector<TargetProfile> profiles = {
      Profile(sensor::Laser::kHorizontal, 0.75, {{2, 0.1, 0.4}, {2.3, 0, 0.4}, {2, -0.2, 0.4}}),
      Profile(sensor::Laser::kVertical, 0.5, {{2, 0, 0.9}, {2, 0, 0.4}}),
      Profile(sensor::Laser::kHorizontal, 0.25, {{2, 0.3, 0.8}, {2.5, -0.1, 0.8}})};
  const auto horizontal = FindProfileEnds(profiles, sensor::Laser::kHorizontal, kCamera);
  ASSERT_EQ(horizontal.size(), 2U);
  EXPECT_EQ(horizontal[0].fraction, 0.25);
  EXPECT_TRUE(horizontal[0].first_B_m.isApprox(Eigen::Vector3d(-0.3, 0.2, 2.0)));
  EXPECT_TRUE(horizontal[0].last_B_m.isApprox(Eigen::Vector3d(0.1, 0.2, 2.5)));
  const auto vertical = FindProfileEnds(profiles, sensor::Laser::kVertical, kCamera);
  ASSERT_EQ(vertical.size(), 1U);
  EXPECT_NEAR(vertical[0].length_m, 0.5, 1e-12);
}

TEST(FindProfileEnds, LengthRunsAcrossTheImageNotInDepth) {
  const std::vector<TargetProfile> profiles = {
      Profile(sensor::Laser::kHorizontal, 0.5, {{2, 0.3, 0.8}, {2.5, -0.1, 0.8}})};
  const auto ends = FindProfileEnds(profiles, sensor::Laser::kHorizontal, kCamera);
  EXPECT_NEAR(ends[0].length_m, 0.4, 1e-12);
}

TEST(FindProfileEnds, LeavesOutProfilesWithoutPoints) {
  const std::vector<TargetProfile> profiles = {
      Profile(sensor::Laser::kHorizontal, 0.5, {}),
      Profile(sensor::Laser::kHorizontal, 0.25, {{2, 0, 0}})};
  EXPECT_TRUE(FindProfileEnds(profiles, sensor::Laser::kHorizontal, kCamera).empty());
}

}  // namespace
}  // namespace geon::recognition
