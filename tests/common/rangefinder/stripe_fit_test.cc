#include "rangefinder/stripe_fit.h"

#include <gtest/gtest.h>

#include "tests/common/rangefinder/synthetic_stripe.h"

namespace geon::rangefinder {
namespace {

sensor::Image Noiseless(double position_px, double amplitude_1) {
  SyntheticStripe stripe;
  stripe.width_px = 1;
  stripe.height_px = 80;
  stripe.noise_1 = 0.0;
  stripe.amplitude_1 = amplitude_1;
  stripe.position_px = [=](int) { return position_px; };
  return stripe.Render();
}

std::optional<ProfileFit> FitOf(const sensor::Image& image) {
  const auto runs = FindRuns(image, sensor::Laser::kHorizontal, 24);
  return FitGaussians(LineView(image, sensor::Laser::kHorizontal), {&runs.at(0), 1}, 24.0,
                      {6.0, 0.3})
      .at(0);
}

TEST(StripeFitTest, MomentsAndLogarithmsKnowPlaceHeightAndWidth) {
  for (const double amplitude_1 : {60.0, 200.0, 800.0}) {
    for (const double phase_px : {0.0, 0.2, 0.5, 0.8}) {
      const auto fit = FitOf(Noiseless(40.0 + phase_px, amplitude_1));
      ASSERT_TRUE(fit.has_value());
      EXPECT_NEAR(fit->position_px, 40.0 + phase_px, 0.02) << amplitude_1;
      EXPECT_NEAR(fit->peak_1, amplitude_1, 0.1 * amplitude_1);
      EXPECT_NEAR(fit->width_px, 2.0, 0.1);
    }
  }
}

TEST(StripeFitTest, TwoCrestsAreNoProfile) {
  sensor::Image image = Noiseless(30.0, 150.0);
  const sensor::Image other = Noiseless(39.0, 150.0);
  for (size_t i = 0; i < image.data.size(); ++i) {
    image.data[i] = std::max<uint8_t>({image.data[i], other.data[i], 25});
  }
  EXPECT_FALSE(FitOf(image).has_value());
}

TEST(StripeFitTest, MisfitOfANoiselessGaussianIsNearlyNothing) {
  const sensor::Image image = Noiseless(40.3, 200.0);
  const auto fit = FitOf(image);
  ASSERT_TRUE(fit.has_value());
  const Misfit misfit = MeasureMisfit(LineView(image, sensor::Laser::kHorizontal), 0, *fit);
  EXPECT_GT(misfit.freedom, 5.0);
  EXPECT_LT(misfit.square_sum_1, 2.0 * misfit.freedom);
}

TEST(StripeFitTest, CentroidIgnoresWhatLiesBelowItsBase) {
  const sensor::Image image = Noiseless(40.5, 200.0);
  const auto fit =
      MeasureCentroid(LineView(image, sensor::Laser::kHorizontal), {0, 36, 45}, 0.3, 0.2, 7);
  ASSERT_TRUE(fit.has_value());
  EXPECT_NEAR(fit->position_px, 40.5, 0.01);
  EXPECT_NEAR(fit->width_px, 2.0, 0.15);
}

}  // namespace
}  // namespace geon::rangefinder
