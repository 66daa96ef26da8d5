#include "recognition/smooth_profile.h"

#include <gtest/gtest.h>

#include "base/contracts.h"
#include "geometry/rigid_transform.h"

namespace geon::recognition {
namespace {

// A camera at the origin of L that looks along x; z of the camera is x of L.
const Eigen::Vector3d kEye_m = Eigen::Vector3d::Zero();
const Eigen::Matrix3d kEyeRotation = geometry::CameraAxesInBody();

sensor::RangeProfile ProfileWithDepths(const std::vector<double>& depth_m) {
  sensor::RangeProfile profile;
  for (size_t i = 0; i < depth_m.size(); ++i) {
    profile.pixel.push_back(static_cast<int>(i));
    profile.p_L_m.push_back(depth_m[i] *
                            Eigen::Vector3d(1.0, -0.001 * static_cast<double>(i), 0.1));
  }
  return profile;
}

sensor::RangeProfile Smooth(const sensor::RangeProfile& profile, Smoothing kind,
                            int half_width_px) {
  SmoothingOptions options;
  options.kind = kind;
  options.half_width_px = half_width_px;
  return SmoothProfile(profile, kEye_m, kEyeRotation, options);
}

TEST(SmoothProfile, MedianRemovesASpikeAndLeavesItsNeighbours) {
  const auto smooth =
      Smooth(ProfileWithDepths({1, 1, 1, 1, 1.5, 1, 1, 1, 1}), Smoothing::kMedian, 2);
  for (const Eigen::Vector3d& p : smooth.p_L_m) EXPECT_DOUBLE_EQ(p.x(), 1.0);
}

TEST(SmoothProfile, GaussianSpreadsASpikeToItsNeighbours) {
  const auto smooth =
      Smooth(ProfileWithDepths({1, 1, 1, 1, 1.5, 1, 1, 1, 1}), Smoothing::kGaussian, 2);
  EXPECT_GT(smooth.p_L_m[3].x(), 1.01);
  EXPECT_LT(smooth.p_L_m[4].x(), 1.45);
  EXPECT_DOUBLE_EQ(smooth.p_L_m[0].x(), 1.0);
}

TEST(SmoothProfile, NoneChangesNothing) {
  const auto profile = ProfileWithDepths({1, 2, 1});
  EXPECT_EQ(Smooth(profile, Smoothing::kNone, 2).p_L_m, profile.p_L_m);
}

TEST(SmoothProfile, MedianKeepsADepthStepWhereItIs) {
  const std::vector<double> step_m = {1, 1, 1, 1, 2, 2, 2, 2};
  const auto smooth = Smooth(ProfileWithDepths(step_m), Smoothing::kMedian, 2);
  for (size_t i = 0; i < step_m.size(); ++i) EXPECT_DOUBLE_EQ(smooth.p_L_m[i].x(), step_m[i]);
}

TEST(SmoothProfile, DoesNotReachAcrossAMissingPixel) {
  auto profile = ProfileWithDepths({1, 1, 1, 2, 2, 2});
  for (size_t i = 3; i < 6; ++i) profile.pixel[i] += 1;
  const auto smooth = Smooth(profile, Smoothing::kGaussian, 2);
  EXPECT_DOUBLE_EQ(smooth.p_L_m[2].x(), 1.0);
  EXPECT_DOUBLE_EQ(smooth.p_L_m[3].x(), 2.0);
}

TEST(SmoothProfile, PointsStayOnTheirViewingRays) {
  const auto profile = ProfileWithDepths({1.0, 1.1, 1.4, 1.2, 1.3});
  const auto smooth = Smooth(profile, Smoothing::kMedian, 1);
  for (size_t i = 0; i < profile.p_L_m.size(); ++i) {
    EXPECT_NEAR(smooth.p_L_m[i].cross(profile.p_L_m[i]).norm(), 0.0, 1e-12);
  }
}

TEST(SmoothProfile, RefusesImpossibleOptions) {
  EXPECT_THROW(Smooth(ProfileWithDepths({1}), Smoothing::kMedian, -1), ContractViolation);
}

}  // namespace
}  // namespace geon::recognition
