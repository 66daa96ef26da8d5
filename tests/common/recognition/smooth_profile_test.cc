#include "recognition/smooth_profile.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

using Depths = std::vector<double>;

Depths Smooth(const Depths& depth_m, Smoothing kind, int half_width_px) {
  std::vector<int> pixel(depth_m.size());
  std::iota(pixel.begin(), pixel.end(), 0);
  SmoothingOptions options;
  options.kind = kind;
  options.half_width_px = half_width_px;
  return SmoothDepths(pixel, depth_m, options);
}

TEST(SmoothDepths, MedianRemovesASpikeAndLeavesItsNeighbours) {
  const Depths spike_m = {1, 1, 1, 1, 1.5, 1, 1, 1, 1};
  EXPECT_EQ(Smooth(spike_m, Smoothing::kMedian, 2), Depths(9, 1.0));
}

TEST(SmoothDepths, GaussianSpreadsASpikeToItsNeighbours) {
  const Depths smooth_m = Smooth({1, 1, 1, 1, 1.5, 1, 1, 1, 1}, Smoothing::kGaussian, 2);
  EXPECT_GT(smooth_m[3], 1.01);
  EXPECT_LT(smooth_m[4], 1.45);
  EXPECT_DOUBLE_EQ(smooth_m[0], 1.0);
}

TEST(SmoothDepths, NoneChangesNothing) {
  EXPECT_EQ(Smooth({1, 2, 1}, Smoothing::kNone, 2), Depths({1, 2, 1}));
}

TEST(SmoothDepths, MedianKeepsADepthStepWhereItIs) {
  const Depths step_m = {1, 1, 1, 1, 2, 2, 2, 2};
  EXPECT_EQ(Smooth(step_m, Smoothing::kMedian, 2), step_m);
}

TEST(SmoothDepths, DoesNotReachAcrossAMissingPixel) {
  const std::vector<int> pixel = {0, 1, 2, 4, 5, 6};
  SmoothingOptions options;
  options.kind = Smoothing::kGaussian;
  const Depths smooth_m = SmoothDepths(pixel, Depths{1, 1, 1, 2, 2, 2}, options);
  EXPECT_DOUBLE_EQ(smooth_m[2], 1.0);
  EXPECT_DOUBLE_EQ(smooth_m[3], 2.0);
}

TEST(SmoothDepths, RefusesImpossibleOptions) {
  EXPECT_THROW(Smooth({1}, Smoothing::kMedian, -1), ContractViolation);
}

}  // namespace
}  // namespace geon::recognition
