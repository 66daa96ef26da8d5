#include "sim/lens_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geon::sim {
namespace {

BuiltCamera Barrel(double corner_px) {
  BuiltCamera camera;
  camera.ideal.width_px = 160;
  camera.ideal.height_px = 120;
  camera.ideal.cx_px = 81.0;
  camera.ideal.cy_px = 58.0;
  camera.lens.middle_px = {78.0, 61.0};
  camera.lens.bend_1_px2 = -corner_px / std::pow(100.0, 3);
  return camera;
}

// A picture without corners, by ideal pixels; three channels.
double Smooth(const Eigen::Vector2d& ideal_px, int channel) {
  return std::sin(0.11 * ideal_px.x() + 0.3 * channel) * std::cos(0.13 * ideal_px.y()) +
         0.02 * ideal_px.x();
}

TEST(LensTest, SeenAndIdealAreEachOthersInverse) {
  for (const double corner_px : {-3.0, 0.0, 3.0}) {
    const Lens lens = Barrel(corner_px).lens;
    for (const Eigen::Vector2d& seen_px :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(159, 119), Eigen::Vector2d(78, 61)}) {
      EXPECT_NEAR((lens.Seen(lens.Ideal(seen_px)) - seen_px).norm(), 0.0, 1e-9);
    }
  }
}

TEST(LensTest, BarrelDrawsTheCornersInward) {
  const BuiltCamera camera = Barrel(3.0);
  const Eigen::Vector3d far_out = camera.ideal.Ray(160.0, 120.0);
  const Eigen::Vector2d seen_px = camera.Project(far_out), middle_px = camera.lens.middle_px;
  EXPECT_LT((seen_px - middle_px).norm(), (Eigen::Vector2d(160, 120) - middle_px).norm() - 2.0);
  EXPECT_NEAR((camera.Ray(seen_px) - far_out).norm(), 0.0, 1e-12);
}

TEST(LensMapTest, EachPixelTakesTheLightThatItsRayMeets) {
  for (const int shrink : {1, 2}) {
    const BuiltCamera camera = Barrel(3.0);
    const LensMap map(camera, shrink);
    constexpr int kChannels = 3;
    std::vector<float> light, between, seen;
    for (int v = 0; v < map.wide().height_px; ++v) {
      for (int u = 0; u < map.wide().width_px; ++u) {
        const Eigen::Vector2d ideal_px = camera.ideal.Project(map.wide().Ray(u, v));
        for (int c = 0; c < kChannels; ++c) {
          light.push_back(static_cast<float>(Smooth(ideal_px, c)));
        }
      }
    }
    map.Apply(kChannels, light, &between, &seen);
    ASSERT_EQ(seen.size(), size_t{160} * 120 * kChannels);
    double worst = 0.0;
    for (int v = 0; v < 120; ++v) {
      for (int u = 0; u < 160; ++u) {
        const Eigen::Vector2d ideal_px = camera.lens.Ideal(Eigen::Vector2d(u, v));
        for (int c = 0; c < kChannels; ++c) {
          const auto at = static_cast<size_t>((v * 160 + u) * kChannels + c);
          worst = std::max(worst, std::abs(static_cast<double>(seen[at]) - Smooth(ideal_px, c)));
        }
      }
    }
    EXPECT_LT(worst, shrink == 1 ? 2e-4 : 2e-3);  // of a wave of 50 px
  }
}

TEST(LensMapTest, WithoutALensNothingIsTouched) {
  const BuiltCamera camera = Barrel(0.0);
  const LensMap map(camera, 1);
  EXPECT_EQ(map.wide().width_px, 160);
  EXPECT_EQ(map.wide().height_px, 120);
  std::vector<float> light(size_t{160} * 120), between, seen;
  for (size_t k = 0; k < light.size(); ++k) light[k] = static_cast<float>(k);
  map.Apply(1, light, &between, &seen);
  EXPECT_EQ(seen, light);
}

}  // namespace
}  // namespace geon::sim
