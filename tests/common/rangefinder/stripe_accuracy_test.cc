#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "rangefinder/stripe_peaks.h"
#include "tests/common/rangefinder/synthetic_stripe.h"

namespace geon::rangefinder {
namespace {

// No unbiased estimate of a stripe's position can have a smaller standard error: the Cramer-Rao
// bound of position, height, width and floor of a Gaussian, integrated over pixels whose noise
// grows with their light. Derivatives by differences of the model itself.
double CramerRaoBound(const SyntheticStripe& stripe) {
  const double frames = stripe.minus_unlit ? 2.0 : 1.0;
  const auto model = [](const Eigen::Vector4d& p, double i) {
    const double scale = std::sqrt(2.0) * p[2];
    return p[3] + p[1] * p[2] * std::sqrt(std::acos(-1.0) / 2.0) *
                      (std::erf((i + 0.5 - p[0]) / scale) - std::erf((i - 0.5 - p[0]) / scale));
  };
  const auto variance = [&](double light_1) {
    return frames * (stripe.noise_1 * stripe.noise_1 + 1.0 / 12.0) +
           stripe.gain_1 * (light_1 + (frames - 1.0) * stripe.background_1);
  };
  double bound_px2 = 0.0;
  constexpr int kPhases = 10;
  for (int phase = 0; phase < kPhases; ++phase) {
    const Eigen::Vector4d at(static_cast<double>(phase) / kPhases, stripe.amplitude_1,
                             stripe.stripe_px, stripe.background_1);
    Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
    for (int i = -30; i <= 30; ++i) {
      Eigen::Vector4d slope;
      for (int k = 0; k < 4; ++k) {
        constexpr double kStep = 1e-4;
        slope[k] = (model(at + kStep * Eigen::Vector4d::Unit(k), i) -
                    model(at - kStep * Eigen::Vector4d::Unit(k), i)) /
                   (2.0 * kStep);
      }
      // Normal noise: its size tells about the light, too.
      const double v = variance(model(at, i));
      const double by_variance = 0.5 * stripe.gain_1 * stripe.gain_1 / (v * v);
      information += (1.0 / v + by_variance) * slope * slope.transpose();
    }
    bound_px2 += information.inverse()(0, 0) / kPhases;
  }
  return std::sqrt(bound_px2);
}

struct Errors {
  int lines = 0;
  int missing = 0;
  double bias_px = 0.0;
  double rms_px = 0.0;                // bias included
  double reported_rms_px = 0.0;       // as sigma_px says
  double width_px = 0.0;              // mean
  std::vector<double> phase_bias_px;  // by tenths of a pixel
};

Errors Measure(SyntheticStripe stripe, int frames, const PeakOptions& options = {}) {
  stripe.height_px = 160;
  stripe.gain_1 = 0.05;
  constexpr size_t kPhases = 10;
  Errors errors;
  errors.phase_bias_px.resize(kPhases);
  std::vector<int> phase_count(kPhases, 0);
  for (int frame = 0; frame < frames; ++frame) {
    stripe.seed = static_cast<unsigned>(frame + 1);
    stripe.position_px = [frame](int line) {  // a slope with steps of 40 px
      return 50.0 + 0.0137 * frame + 0.0731 * line - (line / 80 % 2) * 40.0 +
             (line >= 400 ? 10 : 0);
    };
    for (const StripePeak& peak : FindStripePeaks(stripe.Render(), stripe.laser, options)) {
      if (peak.reason != PeakReason::kFound) {
        ++errors.missing;
        continue;
      }
      const double truth_px = *stripe.position_px(peak.pixel);
      const double error_px = peak.position_px - truth_px;
      ++errors.lines;
      errors.bias_px += error_px;
      errors.rms_px += error_px * error_px;
      errors.reported_rms_px += peak.sigma_px * peak.sigma_px;
      errors.width_px += peak.width_px;
      const auto phase = static_cast<size_t>((truth_px - std::floor(truth_px)) * kPhases);
      errors.phase_bias_px[phase] += error_px;
      ++phase_count[phase];
    }
  }
  errors.bias_px /= errors.lines;
  errors.rms_px = std::sqrt(errors.rms_px / errors.lines);
  errors.reported_rms_px = std::sqrt(errors.reported_rms_px / errors.lines);
  errors.width_px /= errors.lines;
  for (size_t k = 0; k < kPhases; ++k) errors.phase_bias_px[k] /= phase_count[k];
  return errors;
}

constexpr int kFrames = 20;

class StripeAccuracyTest : public testing::TestWithParam<std::tuple<double, double, bool>> {
 protected:
  static SyntheticStripe Stripe() {
    SyntheticStripe stripe;
    stripe.gain_1 = 0.05;
    stripe.amplitude_1 = std::get<0>(GetParam());
    stripe.stripe_px = std::get<1>(GetParam());
    stripe.minus_unlit = std::get<2>(GetParam());
    return stripe;
  }
};

TEST_P(StripeAccuracyTest, GaussianComesNearTheCramerRaoBoundAndKnowsItsError) {
  const SyntheticStripe stripe = Stripe();
  const double bound_px = CramerRaoBound(stripe);
  const Errors errors = Measure(stripe, kFrames);
  RecordProperty("bound_px", std::to_string(bound_px));
  RecordProperty("rms_px", std::to_string(errors.rms_px));
  EXPECT_LE(errors.rms_px, 1.15 * bound_px);
  EXPECT_LE(std::abs(errors.bias_px), 0.003);
  EXPECT_EQ(errors.missing, 0);
  EXPECT_NEAR(errors.reported_rms_px / errors.rms_px, 1.0, 0.2);
  EXPECT_NEAR(errors.width_px, stripe.stripe_px, 0.06 * stripe.stripe_px);
}

INSTANTIATE_TEST_SUITE_P(HeightsAndWidths, StripeAccuracyTest,
                         testing::Combine(testing::Values(60.0, 120.0, 220.0),
                                          testing::Values(1.0, 2.0, 3.0), testing::Bool()));

TEST(StripeAccuracyTest, NoPhaseOfAPixelIsBiased) {
  for (const double width_px : {1.0, 2.0, 3.0}) {
    SyntheticStripe stripe;
    stripe.amplitude_1 = 220.0;
    stripe.stripe_px = width_px;
    for (const double bias_px : Measure(stripe, 60).phase_bias_px) {
      EXPECT_LE(std::abs(bias_px), 0.003) << width_px;
    }
  }
}

TEST(StripeAccuracyTest, FourfoldSaturationStillLeavesAFortiethOfAPixel) {
  for (const bool minus_unlit : {false, true}) {
    SyntheticStripe stripe;
    stripe.amplitude_1 = 4.0 * 220.0;
    stripe.minus_unlit = minus_unlit;
    const Errors errors = Measure(stripe, kFrames);
    // Two frames, each with its noise.
    EXPECT_LE(errors.rms_px, minus_unlit ? 0.025 * std::sqrt(2.0) : 0.025);
    EXPECT_EQ(errors.missing, 0);
    EXPECT_NEAR(errors.reported_rms_px / errors.rms_px, 1.0, minus_unlit ? 0.25 : 0.2);
  }
}

TEST(StripeAccuracyTest, CentroidIsTheBaseline) {
  SyntheticStripe stripe;
  stripe.amplitude_1 = 180.0;
  PeakOptions centroid;
  centroid.method = PeakMethod::kCentroid;
  const Errors errors = Measure(stripe, kFrames, centroid);
  EXPECT_LE(errors.rms_px, 0.05);
  EXPECT_LE(std::abs(errors.bias_px), 0.003);
  EXPECT_GT(errors.rms_px, Measure(stripe, kFrames).rms_px);
}

}  // namespace
}  // namespace geon::rangefinder
