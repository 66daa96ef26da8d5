#include "rangefinder/stripe_peaks.h"

#include <gtest/gtest.h>

#include <string>

#include "base/contracts.h"
#include "tests/common/rangefinder/synthetic_stripe.h"

namespace geon::rangefinder {
namespace {

using sensor::Laser;

struct Accuracy {
  int found = 0;
  double bias_px = 0.0;
  double rms_px = 0.0;  // bias taken off
  double mean_width_px = 0.0;
};

Accuracy Measure(const SyntheticStripe& stripe) {
  Accuracy accuracy;
  double square_sum = 0.0;
  for (const StripePeak& peak : FindStripePeaks(stripe.Render(), stripe.laser)) {
    if (peak.reason != PeakReason::kFound) continue;
    const double error_px = peak.position_px - stripe.position_px(peak.pixel).value();
    ++accuracy.found;
    accuracy.bias_px += error_px;
    accuracy.mean_width_px += peak.width_px;
    square_sum += error_px * error_px;
  }
  accuracy.bias_px /= accuracy.found;
  accuracy.mean_width_px /= accuracy.found;
  accuracy.rms_px = std::sqrt(square_sum / accuracy.found - accuracy.bias_px * accuracy.bias_px);
  return accuracy;
}

SyntheticStripe Sloping() {
  SyntheticStripe stripe;
  stripe.position_px = [](int line) { return 200.3 + 0.07 * line; };
  return stripe;
}

int CountReason(const std::vector<StripePeak>& peaks, PeakReason reason, int begin, int end) {
  int count = 0;
  for (int line = begin; line < end; ++line) {
    count += peaks[static_cast<size_t>(line)].reason == reason ? 1 : 0;
  }
  return count;
}

// A spot of light in an image.
void Paint(sensor::Image* image, const sensor::PixelBox& box, uint8_t level) {
  for (int v = box.v_px; v < box.v_px + box.h_px; ++v) {
    for (int u = box.u_px; u < box.u_px + box.w_px; ++u) {
      image->data[static_cast<size_t>(v * image->row_stride_bytes + u)] = level;
    }
  }
}

TEST(StripePeaksTest, BrightStripeIsMeasuredToAFewHundredthsOfAPixel) {
  const Accuracy accuracy = Measure(Sloping());
  EXPECT_EQ(accuracy.found, 640);
  EXPECT_LT(std::abs(accuracy.bias_px), 0.01);
  EXPECT_LT(accuracy.rms_px, 0.06);
  EXPECT_NEAR(accuracy.mean_width_px, 2.0, 0.15);
}

TEST(StripePeaksTest, FaintStripeIsFoundWithoutBias) {
  SyntheticStripe faint = Sloping();
  faint.amplitude_1 = 45.0;
  const Accuracy accuracy = Measure(faint);
  EXPECT_GT(accuracy.found, 630);
  EXPECT_LT(std::abs(accuracy.bias_px), 0.03);
  EXPECT_LT(accuracy.rms_px, 0.25);
}

TEST(StripePeaksTest, SaturationDoesNotPullTheCentre) {
  SyntheticStripe saturated = Sloping();
  saturated.amplitude_1 = 720.0;
  const Accuracy accuracy = Measure(saturated);
  EXPECT_EQ(accuracy.found, 640);
  EXPECT_LT(std::abs(accuracy.bias_px), 0.01);
  EXPECT_LT(accuracy.rms_px, 0.05);
}

TEST(StripePeaksTest, BackgroundDoesNotPullTheCentreToTheImagesMiddle) {
  SyntheticStripe high = Sloping();
  high.background_1 = 40.0;
  high.position_px = [](int) { return 20.25; };  // far from the middle
  const Accuracy accuracy = Measure(high);
  EXPECT_EQ(accuracy.found, 640);
  EXPECT_LT(std::abs(accuracy.bias_px), 0.02);
}

TEST(StripePeaksTest, VerticalStripeIsTheHorizontalOneTurned) {
  SyntheticStripe vertical = Sloping();
  vertical.laser = Laser::kVertical;
  const Accuracy accuracy = Measure(vertical);
  EXPECT_EQ(accuracy.found, 480);
  EXPECT_LT(accuracy.rms_px, 0.06);
}

TEST(StripePeaksTest, ImageWithoutLightHasNoPeaks) {
  SyntheticStripe dark = Sloping();
  dark.position_px = [](int) { return std::nullopt; };
  const auto peaks = FindStripePeaks(dark.Render(), Laser::kHorizontal);
  ASSERT_EQ(peaks.size(), 640U);
  EXPECT_EQ(CountReason(peaks, PeakReason::kFound, 0, 640), 0);
  EXPECT_EQ(peaks[17].pixel, 17);
}

TEST(StripePeaksTest, NothingIsInventedInTheGapsOfABrokenStripe) {
  SyntheticStripe broken = Sloping();
  broken.position_px = [](int line) -> std::optional<double> {
    const bool gap = (line >= 100 && line < 160) || (line >= 300 && line < 308) || line >= 600;
    return gap ? std::nullopt : std::optional<double>(220.0 + 0.1 * line);
  };
  const auto peaks = FindStripePeaks(broken.Render(), Laser::kHorizontal);
  EXPECT_EQ(CountReason(peaks, PeakReason::kFound, 100, 160), 0);
  EXPECT_EQ(CountReason(peaks, PeakReason::kFound, 300, 308), 0);
  EXPECT_EQ(CountReason(peaks, PeakReason::kFound, 600, 640), 0);
  EXPECT_EQ(CountReason(peaks, PeakReason::kFound, 0, 640), 640 - 108);
}

TEST(StripePeaksTest, StepsAreKept) {
  SyntheticStripe step = Sloping();
  step.position_px = [](int line) { return line < 250 || line >= 400 ? 300.0 : 215.5; };
  const auto peaks = FindStripePeaks(step.Render(), Laser::kHorizontal);
  EXPECT_EQ(CountReason(peaks, PeakReason::kFound, 0, 640), 640);
  EXPECT_NEAR(peaks[249].position_px, 300.0, 0.2);
  EXPECT_NEAR(peaks[250].position_px, 215.5, 0.2);
}

TEST(StripePeaksTest, SpecksBesideTheStripeDoNotDrawItAway) {
  sensor::Image image = Sloping().Render();
  for (int k = 0; k < 12; ++k) Paint(&image, {40 + 50 * k, 400, 3, 3}, 255);
  for (const StripePeak& peak : FindStripePeaks(image, Laser::kHorizontal)) {
    ASSERT_EQ(peak.reason, PeakReason::kFound);
    EXPECT_NEAR(peak.position_px, 200.3 + 0.07 * peak.pixel, 0.5);
  }
}

TEST(StripePeaksTest, SpeckWhereThereIsNoStripeIsRefused) {
  SyntheticStripe half = Sloping();
  half.position_px = [](int line) {
    return line < 300 ? std::optional<double>(200.0) : std::nullopt;
  };
  sensor::Image image = half.Render();
  Paint(&image, {450, 100, 4, 4}, 255);
  const auto peaks = FindStripePeaks(image, Laser::kHorizontal);
  EXPECT_EQ(CountReason(peaks, PeakReason::kFound, 300, 640), 0);
  EXPECT_EQ(CountReason(peaks, PeakReason::kSpeck, 449, 455), 4);
}

TEST(StripePeaksTest, GlareIsTooWideToBeAStripe) {
  SyntheticStripe dark = Sloping();
  dark.position_px = [](int) { return std::nullopt; };
  sensor::Image image = dark.Render();
  Paint(&image, {200, 100, 150, 120}, 250);
  const auto peaks = FindStripePeaks(image, Laser::kHorizontal);
  EXPECT_EQ(CountReason(peaks, PeakReason::kFound, 0, 640), 0);
  EXPECT_GT(CountReason(peaks, PeakReason::kTooWide, 200, 350), 140);
}

TEST(StripePeaksTest, TwoEqualStripesAreAmbiguous) {
  sensor::Image image = Sloping().Render();
  SyntheticStripe other = Sloping();
  other.seed = 2;
  other.position_px = [](int line) { return 330.0 + 0.07 * line; };
  const sensor::Image twin = other.Render();
  for (size_t i = 0; i < image.data.size(); ++i) {
    image.data[i] = std::max(image.data[i], twin.data[i]);
  }
  const auto peaks = FindStripePeaks(image, Laser::kHorizontal);
  EXPECT_EQ(CountReason(peaks, PeakReason::kAmbiguous, 0, 640), 640);
}

TEST(StripePeaksTest, OptionsAreUsed) {
  SyntheticStripe faint = Sloping();
  faint.amplitude_1 = 45.0;
  PeakOptions options;
  options.min_peak_1 = 100.0;
  const auto peaks = FindStripePeaks(faint.Render(), Laser::kHorizontal, options);
  EXPECT_EQ(CountReason(peaks, PeakReason::kTooFaint, 0, 640), 640);
}

TEST(StripePeaksTest, ReasonsHaveNames) {
  EXPECT_EQ(ToString(PeakReason::kTooFaint), "too_faint");
  EXPECT_EQ(ToString(PeakReason::kAmbiguous), "ambiguous");
}

TEST(StripePeaksTest, BrokenContractsThrow) {
  sensor::Image image = Sloping().Render();
  EXPECT_THROW(FindStripePeaks(image, Laser::kNone), ContractViolation);
  PeakOptions options;
  options.base_fraction_1 = 0.6;
  EXPECT_THROW(FindStripePeaks(image, Laser::kHorizontal, options), ContractViolation);
  image.format = sensor::PixelFormat::kRgb8;
  EXPECT_THROW(FindStripePeaks(image, Laser::kHorizontal), ContractViolation);
}

}  // namespace
}  // namespace geon::rangefinder
