#include "sim/trouble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/random_world.h"
#include "sim/world_file.h"

namespace geon::sim {
namespace {

struct Trial {
  World world = RandomWorld(3, GeonPlace::kBox);
  SimOptions options;
};

Trial Troubled(uint64_t seed) {
  Trial trial;
  AddTrouble(seed, &trial.world, &trial.options);
  return trial;
}

const WorldObject& TargetOf(const World& world) {
  return *std::find_if(world.objects.begin(), world.objects.end(), IsTarget);
}

// Everything that is drawn.
std::vector<double> Drawn(const Trial& trial) {
  const Eigen::Vector3d color_rgb = TargetOf(trial.world).color_rgb;
  const Lighting& light = trial.world.lighting;
  const RendererOptions& cameras = trial.options.renderer;
  return {trial.options.base.drive.odometry_distance_scale_1,
          trial.options.base.drive.odometry_turn_scale_1,
          trial.world.groove_tilt_rad,
          light.kelvin,
          light.level_1,
          light.sun.level_1,
          light.sun.azimuth_rad,
          light.sun.elevation_rad,
          trial.world.floor_gloss_1,
          cameras.color.dropped_1,
          cameras.stripe.dropped_1,
          cameras.floor.dropped_1,
          color_rgb[0],
          color_rgb[1],
          color_rgb[2]};
}

// Smallest and largest of what `of` draws out of many runs, which must come near both bounds.
template <typename Of>
void ExpectSpread(double low, double high, Of of) {
  constexpr int kRuns = 400;
  double least = 1e9, most = -1e9;
  for (int seed = 1; seed <= kRuns; ++seed) {
    const double value = of(Troubled(static_cast<uint64_t>(seed)));
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_GE(least, low);
  EXPECT_LE(most, high);
  EXPECT_LT(least, low + 0.05 * (high - low));
  EXPECT_GT(most, high - 0.05 * (high - low));
}

TEST(TroubleTest, TheSameSeedGivesTheSameTroubleAndAnotherSeedOther) {
  EXPECT_EQ(Drawn(Troubled(7)), Drawn(Troubled(7)));
  const auto one = Drawn(Troubled(7)), other = Drawn(Troubled(8));
  int different = 0;
  for (size_t k = 0; k < one.size(); ++k) different += one[k] != other[k] ? 1 : 0;
  EXPECT_GE(different, 13) << "sun and polish may be off in both";
}

TEST(TroubleTest, OdometryTiltAndLostFramesKeepTheirBounds) {
  ExpectSpread(0.98, 1.02, [](const Trial& trial) {
    return trial.options.base.drive.odometry_distance_scale_1;
  });
  ExpectSpread(0.98, 1.02,
               [](const Trial& trial) { return trial.options.base.drive.odometry_turn_scale_1; });
  ExpectSpread(0.0, RadiansFromDegrees(2.0),
               [](const Trial& trial) { return trial.world.groove_tilt_rad; });
  ExpectSpread(0.0, 0.05,
               [](const Trial& trial) { return trial.options.renderer.color.dropped_1; });
  ExpectSpread(0.0, 0.05,
               [](const Trial& trial) { return trial.options.renderer.stripe.dropped_1; });
  ExpectSpread(0.0, 0.05,
               [](const Trial& trial) { return trial.options.renderer.floor.dropped_1; });
}

TEST(TroubleTest, LightKeepsItsBounds) {
  ExpectSpread(3000.0, 6500.0, [](const Trial& trial) { return trial.world.lighting.kelvin; });
  ExpectSpread(0.7, 1.3, [](const Trial& trial) { return trial.world.lighting.level_1; });
  ExpectSpread(RadiansFromDegrees(20.0), RadiansFromDegrees(60.0),
               [](const Trial& trial) { return trial.world.lighting.sun.elevation_rad; });
}

TEST(TroubleTest, AThirdOfTheRunsHasSunAndAThirdAPolishedFloor) {
  int sunny = 0, glossy = 0, both = 0;
  constexpr int kRuns = 900;
  for (int seed = 1; seed <= kRuns; ++seed) {
    const World world = Troubled(static_cast<uint64_t>(seed)).world;
    const double sun_1 = world.lighting.sun.level_1, gloss_1 = world.floor_gloss_1;
    EXPECT_TRUE(sun_1 == 0.0 || (sun_1 >= 0.5 && sun_1 <= 3.0)) << sun_1;
    EXPECT_TRUE(gloss_1 == 0.0 || (gloss_1 >= 0.02 && gloss_1 <= 0.05)) << gloss_1;
    sunny += sun_1 > 0.0 ? 1 : 0;
    glossy += gloss_1 > 0.0 ? 1 : 0;
    both += sun_1 > 0.0 && gloss_1 > 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(sunny, kRuns / 3, 50);
  EXPECT_NEAR(glossy, kRuns / 3, 50);
  EXPECT_NEAR(both, kRuns / 9, 40) << "one does not follow from the other";
}

// CIELAB of a colour as a picture shows it (sRGB, D65; CIE 15).
Eigen::Vector3d Lab(const Eigen::Vector3d& color_rgb) {
  Eigen::Matrix3d to_xyz;
  to_xyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Eigen::Vector3d linear =
      color_rgb.unaryExpr([](double v) { return std::pow((v / 255.0 + 0.055) / 1.055, 2.4); });
  const Eigen::Vector3d f =
      (to_xyz * linear).cwiseQuotient(Eigen::Vector3d(0.9505, 1.0, 1.0891)).unaryExpr([](double v) {
        return std::cbrt(v);
      });
  return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

TEST(TroubleTest, AGeonIsOfAnotherTinOfItsPaint) {
  const Eigen::Vector3d named_lab = Lab(TargetOf(Trial().world).color_rgb);
  double farthest = 0.0, sum = 0.0;
  constexpr int kRuns = 400;
  for (int seed = 1; seed <= kRuns; ++seed) {
    const Trial trial = Troubled(static_cast<uint64_t>(seed));
    const double apart = (Lab(TargetOf(trial.world).color_rgb) - named_lab).norm();
    farthest = std::max(farthest, apart);
    sum += apart;
    EXPECT_FALSE(TargetOf(trial.world).reflectance_1.has_value()) << "left to the colour";
  }
  EXPECT_NEAR(sum / kRuns, 2.5, 0.5);
  EXPECT_LT(farthest, 7.0);
}

TEST(TroubleTest, NothingElseOfTheWorldChanges) {
  World before = Trial().world, after = Troubled(5).world;
  EXPECT_NE(WorldText(before), WorldText(after));
  after.groove_tilt_rad = before.groove_tilt_rad;
  after.lighting = before.lighting;
  after.floor_gloss_1 = before.floor_gloss_1;
  for (size_t k = 0; k < before.objects.size(); ++k) {
    if (IsTarget(before.objects[k])) after.objects[k].color_rgb = before.objects[k].color_rgb;
  }
  EXPECT_EQ(WorldText(before), WorldText(after));
}

TEST(TroubleTest, WhatItMakesCanBeWrittenAndReadAndSimulated) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const Trial trial = Troubled(seed);
    const auto read = ParseWorld(WorldText(trial.world), "troubled.yaml", ".");
    EXPECT_TRUE(read.ok()) << read.message();
    EXPECT_TRUE(Validate(trial.options.renderer).ok());
  }
}

}  // namespace
}  // namespace geon::sim
