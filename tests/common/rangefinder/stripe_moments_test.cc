#include "rangefinder/stripe_moments.h"

#include <gtest/gtest.h>

#include "tests/common/rangefinder/synthetic_stripe.h"

namespace geon::rangefinder {
namespace {

using sensor::Laser;

constexpr double kLevel_1 = 24.0;
constexpr Background kBackground{6.0, 3.0};

// 150 lines, more than are measured side by side; the first thirty leave the image.
SyntheticStripe Leaving(Laser laser) {
  SyntheticStripe stripe;
  stripe.laser = laser;
  stripe.width_px = 150;
  stripe.height_px = 150;
  stripe.position_px = [](int line) { return -3.0 + 0.3 * line; };
  return stripe;
}

TEST(StripeMomentsTest, SideBySideOrAloneAProfileIsTheSame) {
  for (const Laser laser : {Laser::kHorizontal, Laser::kVertical}) {
    const sensor::Image image = Leaving(laser).Render();
    const LineView lines(image, laser);
    const auto runs = FindRuns(image, laser, static_cast<uint8_t>(kLevel_1));
    std::vector<std::optional<ProfileFit>> together(runs.size());
    EXPECT_TRUE(FitByMoments(lines, runs, kLevel_1, kBackground, together).empty());
    int measured = 0;
    for (size_t k = 0; k < runs.size(); ++k) {
      std::vector<std::optional<ProfileFit>> alone(1);
      FitByMoments(lines, {&runs[k], 1}, kLevel_1, kBackground, alone);
      ASSERT_EQ(together[k].has_value(), alone[0].has_value()) << runs[k].line;
      if (!together[k]) continue;
      ++measured;
      EXPECT_EQ(together[k]->position_px, alone[0]->position_px);
      EXPECT_EQ(together[k]->per_gain, alone[0]->per_gain);
      EXPECT_NEAR(together[k]->position_px, -3.0 + 0.3 * runs[k].line, 0.2);
    }
    EXPECT_GT(measured, 110);
    EXPECT_LT(measured, 140);
  }
}

TEST(StripeMomentsTest, ClippedCrestsAreLeftAlone) {
  SyntheticStripe stripe = Leaving(Laser::kHorizontal);
  stripe.amplitude_1 = 600.0;
  stripe.position_px = [](int line) { return 1.0 + 0.3 * line; };  // the first windows leave it
  const sensor::Image image = stripe.Render();
  const LineView lines(image, Laser::kHorizontal);
  const auto runs = FindRuns(image, Laser::kHorizontal, static_cast<uint8_t>(kLevel_1));
  std::vector<std::optional<ProfileFit>> fits(runs.size());
  const auto clipped = FitByMoments(lines, runs, kLevel_1, kBackground, fits);
  EXPECT_EQ(clipped.size(), runs.size());
  for (const auto& fit : fits) EXPECT_FALSE(fit.has_value());
}

TEST(StripeMomentsTest, AWindowThatSuitsBadlyIsChanged) {
  SyntheticStripe stripe;
  stripe.width_px = 1;
  stripe.height_px = 80;
  stripe.noise_1 = 0.0;
  stripe.position_px = [](int) { return 40.2; };
  const sensor::Image image = stripe.Render();
  // Half of the run only: too narrow and beside the crest.
  const rangefinder::Run half{0, 37, 40};  // Run is also a member of testing::Test
  std::vector<std::optional<ProfileFit>> fits(1);
  FitByMoments(LineView(image, Laser::kHorizontal), {&half, 1}, kLevel_1, kBackground, fits);
  ASSERT_TRUE(fits[0].has_value());
  EXPECT_NEAR(fits[0]->position_px, 40.2, 0.02);
  EXPECT_NEAR(fits[0]->width_px, 2.0, 0.1);
}

}  // namespace
}  // namespace geon::rangefinder
