#include "recognition/profile_noise.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

namespace geon::recognition {
namespace {

using Depths = std::vector<double>;

Depths Parabola(double noise_m, int count) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> gauss;
  Depths depth_m;
  for (int k = 0; k < count; ++k) {
    const double t = 0.001 * k;
    depth_m.push_back(1.0 + 3.0 * t * t + noise_m * gauss(random));
  }
  return depth_m;
}

// Of pixels `step` apart.
double Noise(const Depths& depth_m, int step = 1) {
  std::vector<int> pixel(depth_m.size());
  std::iota(pixel.begin(), pixel.end(), 0);
  for (int& p : pixel) p *= step;
  return DepthNoise(pixel, depth_m);
}

TEST(DepthNoise, IsMeasuredWhateverTheSlopeAndCurvature) {
  EXPECT_NEAR(Noise(Parabola(0.001, 2000)), 0.001, 0.0001);
  EXPECT_NEAR(Noise(Parabola(0.0, 200)), 0.0, 1e-12);
}

TEST(DepthNoise, IsNotMovedBySpikesAndSteps) {
  Depths depth_m = Parabola(0.001, 2000);
  for (size_t i = 0; i < depth_m.size(); i += 60) depth_m[i] += 0.1;
  for (size_t i = 1000; i < depth_m.size(); ++i) depth_m[i] += 0.3;
  EXPECT_NEAR(Noise(depth_m), 0.001, 0.0002);
}

TEST(DepthNoise, IsUnknownWithoutFourNeighbours) {
  EXPECT_EQ(Noise(Parabola(0.001, 3)), 0.0);
  EXPECT_EQ(Noise(Parabola(0.001, 60), 2), 0.0);
}

}  // namespace
}  // namespace geon::recognition
