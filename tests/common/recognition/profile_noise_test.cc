#include "recognition/profile_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/rigid_transform.h"
#include "sensor/scan_set.h"

namespace geon::recognition {
namespace {

// A parabola in depth before a level camera at the origin, with noise.
sensor::RangeProfile Parabola(double noise_m, int count) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> gauss;
  sensor::RangeProfile profile;
  for (int k = 0; k < count; ++k) {
    const double t = 0.001 * k;
    profile.pixel.push_back(k);
    profile.p_L_m.emplace_back(1.0 + 3.0 * t * t + noise_m * gauss(random), -t, 0.0);
  }
  return profile;
}

double Noise(const sensor::RangeProfile& profile) {
  return DepthNoise(profile.pixel, ProfileDepths(profile.p_L_m, Eigen::Vector3d::Zero(),
                                                 geometry::CameraAxesInBody()));
}

TEST(DepthNoise, IsMeasuredWhateverTheSlopeAndCurvature) {
  EXPECT_NEAR(Noise(Parabola(0.001, 2000)), 0.001, 0.0001);
  EXPECT_NEAR(Noise(Parabola(0.0, 200)), 0.0, 1e-12);
}

TEST(DepthNoise, IsNotMovedBySpikesAndSteps) {
  sensor::RangeProfile profile = Parabola(0.001, 2000);
  for (size_t i = 0; i < profile.p_L_m.size(); i += 60) profile.p_L_m[i].x() += 0.1;
  for (size_t i = 1000; i < profile.p_L_m.size(); ++i) profile.p_L_m[i].x() += 0.3;
  EXPECT_NEAR(Noise(profile), 0.001, 0.0002);
}

TEST(DepthNoise, IsUnknownWithoutFourNeighbours) {
  EXPECT_EQ(Noise(Parabola(0.001, 3)), 0.0);
  sensor::RangeProfile profile = Parabola(0.001, 60);
  for (size_t i = 0; i < profile.pixel.size(); ++i) profile.pixel[i] *= 2;
  EXPECT_EQ(Noise(profile), 0.0);
}

}  // namespace
}  // namespace geon::recognition
