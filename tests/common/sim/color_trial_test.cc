#include "sim/color_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

namespace geon::sim {
namespace {

// A small camera with the field of view of the robot's.
geometry::PinholeCamera SmallCamera() { return {160, 120, 400.0, 400.0, 79.5, 59.5}; }

ColorPicture Render(const ColorTrial& trial) {
  return RenderColorTrial(trial, SmallCamera(), trial.X_WC, {});
}

// Mean red signal on the target.
double TargetRed(const ColorPicture& picture) {
  double sum = 0.0, count = 0.0;
  for (size_t i = 0; i < picture.is_target.size(); ++i) {
    if (picture.is_target[i] == 0) continue;
    sum += static_cast<double>(picture.signal[3 * i + 2]);
    count += 1.0;
  }
  return sum / count;
}

TEST(ColorTrialTest, FourteenHundredTrialsHoldEveryCombinationOnce) {
  std::set<std::tuple<GeonLabel, double, int, LightCase, bool>> seen;
  for (int t = 0; t < 1400; ++t) {
    const ColorTrial trial = RandomColorTrial(3, t);
    seen.emplace(trial.label, trial.kelvin, trial.stops, trial.light, trial.distractors);
  }
  EXPECT_EQ(seen.size(), 1400U);
}

TEST(ColorTrialTest, EveryTargetIsInThePictureAndNearlyNoneIsHidden) {
  for (int t = 0; t < 28; ++t) {
    const ColorPicture picture = Render(RandomColorTrial(1, t));
    const auto pixels = std::count(picture.is_target.begin(), picture.is_target.end(), 255);
    EXPECT_GE(pixels, 100) << "trial " << t;
    EXPECT_LE(pixels, 160 * 120 / 2) << "trial " << t;
  }
}

TEST(ColorTrialTest, SameSeedSamePictureOtherSeedAnother) {
  const ColorTrial trial = RandomColorTrial(1, 7);
  const ColorPicture picture = Render(trial);
  EXPECT_EQ(picture.signal, Render(RandomColorTrial(1, 7)).signal);
  EXPECT_NE(picture.signal, Render(RandomColorTrial(2, 7)).signal);
  EXPECT_EQ(ExposePicture(picture, 1.0, {}, 5), ExposePicture(picture, 1.0, {}, 5));
  EXPECT_NE(ExposePicture(picture, 1.0, {}, 5), ExposePicture(picture, 1.0, {}, 6));
}

TEST(ColorTrialTest, LevelOfTheLightIsThatOfThePicture) {
  ColorTrial dark = RandomColorTrial(1, 0);
  ASSERT_EQ(dark.stops, -2);
  ColorTrial bright = dark;
  bright.world.lighting.level_1 *= 4.0;
  bright.world.lighting.sun.level_1 *= 4.0;
  EXPECT_NEAR(TargetRed(Render(bright)) / TargetRed(Render(dark)), 4.0, 1e-3);
}

TEST(ColorTrialTest, ShadowEdgeCrossesTheTarget) {
  int crossed = 0, trials = 0;
  for (int t = 0; t < 40; ++t) {
    ColorTrial trial = RandomColorTrial(1, t);
    if (trial.light != LightCase::kShadowEdge) continue;
    ++trials;
    const ColorPicture with_sun = Render(trial);
    trial.world.lighting.sun.level_1 = 0.0;
    const ColorPicture without = Render(trial);
    double lit = 0.0, unlit = 0.0;
    for (size_t i = 0; i < with_sun.is_target.size(); ++i) {
      if (with_sun.is_target[i] == 0) continue;
      (with_sun.signal[3 * i + 2] > without.signal[3 * i + 2] * 1.05F ? lit : unlit) += 1.0;
    }
    if (lit > 0.1 * unlit && unlit > 0.1 * lit) ++crossed;
  }
  EXPECT_EQ(trials, 10);
  EXPECT_GE(crossed, 8) << "sun and shadow both take more than a tenth";
}

TEST(ColorTrialTest, MoreExposureIsMoreLight) {
  const ColorPicture picture = Render(RandomColorTrial(1, 10));
  const auto mean = [](const std::vector<uint8_t>& pixels) {
    double sum = 0.0;
    for (const uint8_t level : pixels) sum += level;
    return sum / static_cast<double>(pixels.size());
  };
  const double once = mean(ExposePicture(picture, 0.25, {}, 1));
  const double twice = mean(ExposePicture(picture, 0.5, {}, 1));
  EXPECT_GT(twice, 1.2 * once) << "2 to the power of 1 / 2.2 is 1.37";
}

}  // namespace
}  // namespace geon::sim
