#include "sim/laser_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/angles.h"
#include "sim/rig_renderer.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

// A camera at the origin of W that looks along z at a board; the fan comes from above (y is down),
// parallel to the optical axis.
struct Bench {
  explicit Bench(double z_m, LaserOptions laser_options = {}) : options(laser_options) {
    options.speckle_1 = 0.0;
    scene = BoardScene(geometry::RigidTransform::Identity(), z_m);
    fan.origin_W_m = {0, -0.05, 0};
    fan.normal_W = Eigen::Vector3d::UnitY();
    fan.forward_W = Eigen::Vector3d::UnitZ();
  }
  std::vector<double> Column(int u) const {
    const std::vector<float> light = Picture(1);
    std::vector<double> column;
    for (int v = 0; v < 480; ++v)
      column.push_back(static_cast<double>(light[static_cast<size_t>(v * 640 + u)]));
    return column;
  }
  std::vector<float> Picture(uint64_t speckle_seed) const {
    std::vector<float> picture(size_t{640} * 480, 0.0F);
    for (const LitPixel& lit : LaserLight(*scene, camera, geometry::RigidTransform::Identity(), fan,
                                          options, speckle_seed)) {
      picture[static_cast<size_t>(lit.v_px * 640 + lit.u_px)] = lit.level_1;
    }
    return picture;
  }
  LaserOptions options;
  std::shared_ptr<const Scene> scene;
  BuiltCamera camera;
  LaserFan fan;
};

struct Profile {
  double sum, centre_px, sigma_px;
};
Profile ProfileOf(const std::vector<double>& column) {
  Profile p{std::accumulate(column.begin(), column.end(), 0.0), 0, 0};
  for (size_t v = 0; v < column.size(); ++v)
    p.centre_px += column[v] * static_cast<double>(v) / p.sum;
  for (size_t v = 0; v < column.size(); ++v) {
    p.sigma_px += column[v] * std::pow(static_cast<double>(v) - p.centre_px, 2) / p.sum;
  }
  p.sigma_px = std::sqrt(p.sigma_px);
  return p;
}

TEST(LaserLightTest, ProfileIsAGaussianOfThePhysicalWidthAtItsPlace) {
  for (const double z_m : {0.8, 1.6}) {
    const Profile p = ProfileOf(Bench(z_m).Column(320));
    EXPECT_NEAR(p.centre_px, 239.5 - 1600 * 0.05 / z_m, 0.01);
    const double sigma_m = 0.0007 * std::sqrt(1 + z_m * z_m / (1.4 * 1.4));
    EXPECT_NEAR(p.sigma_px, std::sqrt(std::pow(sigma_m * 1600 / z_m, 2) + 1.0 / 12), 0.02);
  }
}

TEST(LaserLightTest, IsTwoMillimetresThickAtOneMetre) {
  const Profile p = ProfileOf(Bench(1.0).Column(320));
  EXPECT_NEAR(2.355 * p.sigma_px / 1600, 0.002, 0.0003);  // full width at half maximum
}

TEST(LaserLightTest, FaintsWithDistanceAndStopsAtTheFansEdge) {
  const std::vector<double> near_column = Bench(0.8).Column(320),
                            far_column = Bench(1.6).Column(320);
  EXPECT_LT(*std::max_element(far_column.begin(), far_column.end()),
            0.55 * *std::max_element(near_column.begin(), near_column.end()));
  LaserOptions narrow;
  narrow.fan_half_angle_rad = RadiansFromDegrees(5.0);
  const Bench bench(1.0, narrow);
  EXPECT_GT(ProfileOf(bench.Column(320)).sum, 0.0);
  EXPECT_EQ(ProfileOf(bench.Column(20)).sum, 0.0);
}

TEST(LaserLightTest, SpeckleStandsStillForItsSeedAndGoesAlongTheStripe) {
  Bench bench(1.0);
  bench.options.speckle_1 = 0.17;
  const auto first = bench.Picture(1);
  EXPECT_EQ(first, bench.Picture(1));
  EXPECT_NE(first, bench.Picture(2));
  bench.options.speckle_1 = 0.0;
  const auto clean = bench.Picture(1);
  double squares = 0, along = 0, across = 0, n = 0;
  for (size_t v = 158; v < 161; ++v) {
    for (size_t u = 1; u < 639; ++u) {
      const auto at = [&](size_t row, size_t column) {
        const size_t k = row * 640 + column;
        return static_cast<double>(first[k] / clean[k]) - 1.0;
      };
      squares += at(v, u) * at(v, u), along += at(v, u) * at(v, u + 1),
          across += at(v, u) * at(v + 1, u), n += 1;
    }
  }
  EXPECT_NEAR(std::sqrt(squares / n), 0.17, 0.015);
  EXPECT_NEAR(along / squares, 2.0 / 3.0, 0.08);
  EXPECT_NEAR(across / squares, 0.0, 0.1);
}

}  // namespace
}  // namespace geon::sim
