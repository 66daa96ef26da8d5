#include "rangefinder/stripe_candidates.h"

#include <gtest/gtest.h>

#include "tests/common/rangefinder/synthetic_stripe.h"

namespace geon::rangefinder {
namespace {

using sensor::Laser;

SyntheticStripe Level() {
  SyntheticStripe stripe;
  stripe.position_px = [](int) { return 200.3; };
  return stripe;
}

TEST(StripeCandidatesTest, BackgroundIsMeasuredBesideTheStripe) {
  const Background raw = MeasureBackground(Level().Render());
  EXPECT_NEAR(raw.level_1, 6.0, 0.3);
  EXPECT_NEAR(raw.noise_1, 3.0, 0.3);
  SyntheticStripe difference = Level();
  difference.minus_unlit = true;
  const Background cut = MeasureBackground(difference.Render());
  EXPECT_NEAR(cut.level_1, 0.0, 0.5);
  EXPECT_NEAR(cut.noise_1, 3.0 * std::sqrt(2.0), 0.5);
}

TEST(StripeCandidatesTest, EveryLineOfAStripeHasOne) {
  const sensor::Image image = Level().Render();
  const auto candidates =
      FindCandidates(image, Laser::kHorizontal, MeasureBackground(image), PeakOptions());
  EXPECT_EQ(candidates.size(), 640U);
}

TEST(StripeCandidatesTest, AStripeOnScatteredLightIsTakenOutOfIt) {
  sensor::Image image = Level().Render();
  for (int v = 172; v < 228; ++v) {
    for (int u = 0; u < 640; ++u) {
      uint8_t& level = image.data[static_cast<size_t>(v * 640 + u)];
      level = static_cast<uint8_t>(std::min(255, level + 40));
    }
  }
  const auto candidates =
      FindCandidates(image, Laser::kHorizontal, MeasureBackground(image), PeakOptions());
  int on_stripe = 0;
  for (const PeakCandidate& candidate : candidates) {
    on_stripe += std::abs(candidate.fit.position_px - 200.3) < 0.3 && !candidate.too_wide ? 1 : 0;
  }
  EXPECT_EQ(on_stripe, 640);
}

}  // namespace
}  // namespace geon::rangefinder
