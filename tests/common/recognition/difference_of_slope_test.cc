#include "recognition/difference_of_slope.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/contracts.h"
#include "tests/common/recognition/analytic_curves.h"

namespace geon::recognition {
namespace {

constexpr int kPlotSamples = 80;

CurveFeatures FeaturesOf(const std::vector<Eigen::Vector2d>& curve_m,
                         const DifferenceOfSlopeOptions& options = {}) {
  return FindFeatures(ComputeThetaPlot(curve_m, options), options);
}

ThetaPlot PlotOf(std::vector<double> theta_rad) { return {11, std::move(theta_rad)}; }

TEST(ThetaPlot, IsZeroOnALineAndHasOneValueASample) {
  const ThetaPlot plot = ComputeThetaPlot(PolylineCurve(0.2, {}, kPlotSamples), {});
  EXPECT_EQ(plot.theta_rad.size(), static_cast<size_t>(kPlotSamples - 23 + 1));
  EXPECT_EQ(plot.first, 11);
  for (const double theta_rad : plot.theta_rad) EXPECT_NEAR(theta_rad, 0.0, 1e-9);
}

TEST(ThetaPlot, PeaksWithTheCornersAngleWhereTheCornerIs) {
  const ThetaPlot plot = ComputeThetaPlot(PolylineCurve(0.1, {1.2}, kPlotSamples), {});
  const auto peak = std::max_element(plot.theta_rad.begin(), plot.theta_rad.end());
  EXPECT_NEAR(*peak, 1.2, 0.02);
  EXPECT_NEAR(plot.first + static_cast<double>(peak - plot.theta_rad.begin()), 0.5 * kPlotSamples,
              2.0);
}

TEST(ThetaPlot, IsConstantOnAnArcAndNegativeOnAConcaveOne) {
  // The lines lie W + M samples apart, from middle to middle.
  const double expected_rad = 1.5 * 13.0 / (kPlotSamples - 1);
  for (const double theta_rad : ComputeThetaPlot(ArcCurve(0.1, 1.5, kPlotSamples), {}).theta_rad) {
    EXPECT_NEAR(theta_rad, expected_rad, 0.01);
  }
  for (const double theta_rad : ComputeThetaPlot(ArcCurve(0.1, -1.5, kPlotSamples), {}).theta_rad) {
    EXPECT_NEAR(theta_rad, -expected_rad, 0.01);
  }
}

TEST(ThetaPlot, IsEmptyForACurveShorterThanTwoWindowsAndAGap) {
  EXPECT_TRUE(ComputeThetaPlot(PolylineCurve(0.1, {}, 22), {}).theta_rad.empty());
  EXPECT_EQ(ComputeThetaPlot(PolylineCurve(0.1, {}, 23), {}).theta_rad.size(), 1U);
}

TEST(ThetaPlot, FollowsAProfileThatRunsInDepth) {
  // A vertical run has no slope y(x); its direction is as good as any.
  std::vector<Eigen::Vector2d> curve_m;
  for (int i = 0; i < kPlotSamples; ++i) curve_m.emplace_back(0.0, 0.001 * i);
  for (const double theta_rad : ComputeThetaPlot(curve_m, {}).theta_rad) {
    EXPECT_NEAR(theta_rad, 0.0, 1e-9);
  }
}

TEST(FindFeatures, TellsLineCornerAndCurveApart) {
  EXPECT_EQ(FeaturesOf(PolylineCurve(0.2, {}, kPlotSamples)).corners, 0);
  EXPECT_EQ(FeaturesOf(PolylineCurve(0.2, {}, kPlotSamples)).curves, 0);
  const CurveFeatures corner = FeaturesOf(PolylineCurve(0.1, {1.5}, kPlotSamples));
  EXPECT_EQ(corner.corners, 1);
  EXPECT_EQ(corner.curves, 0);
  const CurveFeatures arc = FeaturesOf(ArcCurve(0.1, 2.5, kPlotSamples));
  EXPECT_EQ(arc.corners, 0);
  EXPECT_EQ(arc.curves, 1);
  EXPECT_EQ(arc.concavities, 0);
}

TEST(FindFeatures, AConcaveArcIsAConcavityAndNoCurve) {
  const CurveFeatures features = FeaturesOf(ArcCurve(0.1, -2.5, kPlotSamples));
  EXPECT_GE(features.concavities, 1);
  EXPECT_EQ(features.curves, 0);
}

TEST(FindFeatures, SurvivesTheNoiseOfAMillimetreOnATwentyCentimetreProfile) {
  auto line_m = PolylineCurve(0.2, {}, kPlotSamples);
  AddNoise(0.0004, 7, &line_m);  // what is left of a millimetre after smoothing and resampling
  const CurveFeatures features = FeaturesOf(line_m);
  EXPECT_EQ(features.curves, 0);
  EXPECT_EQ(features.corners, 0);
  EXPECT_EQ(features.concavities, 0);
}

TEST(FindFeatures, ALowNarrowPeakIsNoise) {
  DifferenceOfSlopeOptions options;
  std::vector<double> theta_rad(60, 0.0);
  std::fill_n(theta_rad.begin() + 20, options.curve_width,
              0.5 * (options.zero_range_rad + options.corner_rad));
  const CurveFeatures features = FindFeatures(PlotOf(theta_rad), options);
  EXPECT_EQ(features.curves, 0);
  EXPECT_EQ(features.corners, 0);
}

TEST(FindFeatures, AHighWidePeakIsACornerBesideACurve) {
  DifferenceOfSlopeOptions options;
  std::vector<double> theta_rad(60, 0.0);
  std::fill_n(theta_rad.begin() + 5, options.curve_width + 1, 2.0 * options.zero_range_rad);
  theta_rad[10] = options.corner_rad + 0.1;
  const CurveFeatures features = FindFeatures(PlotOf(theta_rad), options);
  EXPECT_EQ(features.curves, 1);
  EXPECT_EQ(features.corners, 1);
}

TEST(FindFeatures, APeakThatChangesSignAtOnceIsTwo) {
  DifferenceOfSlopeOptions options;
  options.concave_width = 0;
  const std::vector<double> theta_rad = {0, options.corner_rad + 0.1, -options.concave_rad - 0.1,
                                         0};
  const CurveFeatures features = FindFeatures(PlotOf(theta_rad), options);
  EXPECT_EQ(features.corners, 1);
  EXPECT_EQ(features.concavities, 1);
}

TEST(FindFeatures, ADentOfAFewSamplesIsNoConcavity) {
  DifferenceOfSlopeOptions options;
  options.concave_width = 4;
  std::vector<double> theta_rad(60, 0.0);
  std::fill_n(theta_rad.begin() + 20, 4, -2.0 * options.concave_rad);
  EXPECT_EQ(FindFeatures(PlotOf(theta_rad), options).concavities, 0);
  std::fill_n(theta_rad.begin() + 20, 5, -2.0 * options.concave_rad);
  EXPECT_EQ(FindFeatures(PlotOf(theta_rad), options).concavities, 1);
}

TEST(FindFeatures, AConcavityMustStandOutOfTheNoise) {
  DifferenceOfSlopeOptions options;
  options.concave_noise_1 = 3.0;
  ThetaPlot plot = PlotOf(std::vector<double>(60, -1.5 * options.concave_rad));
  EXPECT_EQ(FindFeatures(plot, options).concavities, 1);
  plot.noise_rad = 0.6 * options.concave_rad;
  EXPECT_EQ(FindFeatures(plot, options).concavities, 0);
}

// The formula against a straight line with noise.
TEST(ThetaNoise, IsTheDeviationOfThetaOnANoisyLine) {
  DifferenceOfSlopeOptions options;
  constexpr double kNoise_m = 0.0003;
  double sum = 0.0;
  int n = 0;
  Eigen::Vector2d step_m = Eigen::Vector2d::Zero();
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    auto line_m = PolylineCurve(0.2, {}, kPlotSamples);
    step_m = line_m[1] - line_m[0];
    AddNoise(kNoise_m, seed, &line_m);
    for (double theta_rad : ComputeThetaPlot(line_m, options).theta_rad) {
      sum += theta_rad * theta_rad;
      ++n;
    }
  }
  const double across_m = kNoise_m * std::abs(step_m.x()) / step_m.norm();  // noise is along y
  EXPECT_NEAR(std::sqrt(sum / n) / ThetaNoise(across_m, 1.0, step_m.norm(), options), 1.0, 0.05);
}

TEST(FindFeatures, RefusesAZeroRangeAboveTheCornerHeight) {
  DifferenceOfSlopeOptions options;
  options.zero_range_rad = options.corner_rad;
  EXPECT_THROW(options.Validate(), ContractViolation);
}

}  // namespace
}  // namespace geon::recognition
