#include "attention/fit_color_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/contracts.h"

namespace geon::attention {
namespace {

constexpr double kTolerance_1 = 0.003;

Eigen::ArrayXXd NoWorth() { return Eigen::ArrayXXd::Zero(kChromaticityBins, kChromaticityBins); }

// A round heap of worth, in shares of red and green.
Eigen::ArrayXXd Heap(double red_1, double green_1, double sigma_1, double sum_1) {
  Eigen::ArrayXXd heap = NoWorth();
  for (int r = 0; r < kChromaticityBins; ++r) {
    for (int g = 0; r + g < kChromaticityBins; ++g) {
      const double dr = (r + 0.5) / kChromaticityBins - red_1;
      const double dg = (g + 0.5) / kChromaticityBins - green_1;
      heap(r, g) = std::exp(-0.5 * (dr * dr + dg * dg) / (sigma_1 * sigma_1));
    }
  }
  return heap * (sum_1 / heap.sum());
}

// The worth of the bins whose colours the region has.
double WorthInside(const HalfSpaceColor& region, const Eigen::ArrayXXd& worth_1) {
  double sum_1 = 0.0;
  for (int r = 0; r < kChromaticityBins; ++r) {
    for (int g = 0; r + g < kChromaticityBins; ++g) {
      bool inside = true;
      for (const ColorHalfSpace& side : region.half_spaces) {
        const double red = r + 0.5, green = g + 0.5, blue = kChromaticityBins - red - green;
        inside = inside && side.red_1 * red + side.green_1 * green + side.blue_1 * blue > 0.0;
      }
      if (inside) sum_1 += worth_1(r, g);
    }
  }
  return sum_1;
}

TEST(FitColorRegionTest, TakesTheHeapOfTheTargetAndNothingOfThoseAround) {
  Eigen::ArrayXXd worth_1 = Heap(0.6, 0.2, 0.03, 1.0);
  worth_1 -= Heap(0.35, 0.33, 0.03, 2.0) + Heap(0.5, 0.4, 0.03, 1.0) + Heap(0.45, 0.12, 0.03, 1.0);
  const FittedRegion fitted = FitColorRegion(worth_1, kTolerance_1);
  EXPECT_GT(fitted.worth_1, 0.95);
  EXPECT_LE(fitted.worth_1, 1.0);
  EXPECT_NEAR(WorthInside(fitted.region, worth_1), fitted.worth_1, 0.01)
      << "whole coefficients decide nearly as the fitted ones";
}

TEST(FitColorRegionTest, SidesAreFewAndWide) {
  // Worth on the left, loss on the right: one straight side between them is all it takes.
  const Eigen::ArrayXXd worth_1 = Heap(0.7, 0.15, 0.03, 1.0) - Heap(0.4, 0.3, 0.03, 1.0);
  const FittedRegion fitted = FitColorRegion(worth_1, kTolerance_1);
  ASSERT_EQ(fitted.region.half_spaces.size(), 1U);
  EXPECT_TRUE(fitted.region.Contains({230, 10, 10})) << "redder than anything taught";
  EXPECT_FALSE(fitted.region.Contains({128, 128, 128}));
}

TEST(FitColorRegionTest, CoefficientsAreWholeAndFitSixteenBits) {
  const FittedRegion fitted =
      FitColorRegion(Heap(0.5, 0.25, 0.05, 1.0) - Heap(1.0 / 3, 1.0 / 3, 0.2, 2.0), kTolerance_1);
  ASSERT_FALSE(fitted.region.half_spaces.empty());
  for (const ColorHalfSpace& side : fitted.region.half_spaces) {
    EXPECT_EQ(side, WholeNumbered(side)) << "the nearest whole plane is the plane itself";
  }
}

TEST(FitColorRegionTest, IsNoWorseThanAnyRectangleOfTriedOnes) {
  std::mt19937 random(7);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int trial = 0; trial < 5; ++trial) {
    Eigen::ArrayXXd worth_1 = Heap(draw(0.3, 0.6), draw(0.15, 0.3), 0.04, 1.0);
    for (int k = 0; k < 3; ++k) worth_1 -= Heap(draw(0.2, 0.7), draw(0.1, 0.3), 0.04, 0.7);
    const double fitted_1 = FitColorRegion(worth_1, kTolerance_1).worth_1;
    for (int k = 0; k < 200; ++k) {
      const auto r = static_cast<int>(draw(0, 90)), g = static_cast<int>(draw(0, 60));
      const auto h = static_cast<int>(draw(2, 38)), w = static_cast<int>(draw(2, 38));
      ASSERT_GE(fitted_1 + 0.05, worth_1.block(r, g, h, w).sum()) << trial;
    }
  }
}

TEST(FitColorRegionTest, NothingWantedGivesNoWorth) {
  EXPECT_LE(FitColorRegion(-Heap(0.5, 0.25, 0.05, 1.0), kTolerance_1).worth_1, 1e-3);
  EXPECT_THROW((void)FitColorRegion(Eigen::ArrayXXd::Zero(3, 3), kTolerance_1), ContractViolation);
}

TEST(FitColorRegionTest, BinsAreSharesOfRedAndGreen) {
  EXPECT_EQ(BinOf({255, 0, 0}).red, kChromaticityBins - 1);
  EXPECT_EQ(BinOf({0, 9, 0}).green, kChromaticityBins - 1);
  EXPECT_EQ(BinOf({100, 100, 200}).red, kChromaticityBins / 4);
  EXPECT_EQ(BinOf({10, 10, 20}).green, kChromaticityBins / 4) << "whatever the brightness";
}

}  // namespace
}  // namespace geon::attention
