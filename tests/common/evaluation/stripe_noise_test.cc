#include "evaluation/stripe_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace geon::evaluation {
namespace {

constexpr size_t kLines = 20000;

std::vector<StripeError> Errors(const FaultOptions& faults) {
  std::mt19937_64 random(3);
  return StripeErrors(kLines, faults, random);
}

double Covariance(const std::vector<StripeError>& errors, size_t lag) {
  double sum = 0.0;
  for (size_t i = lag; i < errors.size(); ++i) {
    sum += errors[i].offset_px * errors[i - lag].offset_px;
  }
  return sum / static_cast<double>(errors.size() - lag);
}

TEST(StripeErrors, WhiteNoiseHasItsDeviationAndNoMemory) {
  const std::vector<StripeError> errors = Errors({});
  EXPECT_NEAR(std::sqrt(Covariance(errors, 0)), 0.1, 0.003);
  EXPECT_NEAR(Covariance(errors, 1) / Covariance(errors, 0), 0.0, 0.03);
}

TEST(StripeErrors, SpeckleRemembersFourLines) {
  FaultOptions faults;
  faults.noise_px = 0.0;
  faults.speckle_px = 0.2;
  const std::vector<StripeError> errors = Errors(faults);
  EXPECT_NEAR(std::sqrt(Covariance(errors, 0)), 0.2, 0.01);
  EXPECT_NEAR(Covariance(errors, 4) / Covariance(errors, 0), std::exp(-1.0), 0.06);
}

TEST(StripeErrors, OutliersAndDropoutsComeAtTheirRates) {
  FaultOptions faults;
  faults.outliers_1 = 0.02;
  faults.dropout_1 = 0.10;
  int far = 0, missing = 0;
  for (const StripeError& error : Errors(faults)) {
    if (std::abs(error.offset_px) > 1.0) ++far;
    if (error.missing) ++missing;
  }
  EXPECT_NEAR(far / static_cast<double>(kLines), 0.02 * 0.95, 0.004);
  EXPECT_NEAR(missing / static_cast<double>(kLines), 0.10, 0.01);
}

TEST(OffsetError, IsOneOffsetAndSlowWavesOfTheirDeviations) {
  FaultOptions faults;
  faults.offset_px = 0.8;
  faults.ripple_px = 0.3;
  constexpr int kImages = 2000;
  double squares = 0.0, ripples = 0.0, steps = 0.0;
  std::mt19937_64 random(1);
  for (int image = 0; image < kImages; ++image) {
    const OffsetError error(faults, random);
    const double here_px = error.At({100.0, -50.0}), there_px = error.At({-200.0, 150.0});
    squares += here_px * here_px;
    ripples += std::pow(here_px - there_px, 2);
    steps = std::max(steps, std::abs(error.At({101.0, -50.0}) - here_px));
  }
  EXPECT_NEAR(std::sqrt(squares / kImages), std::hypot(0.8, 0.3), 0.05);
  EXPECT_NEAR(std::sqrt(ripples / kImages), std::sqrt(2.0) * 0.3, 0.1);
  EXPECT_LT(steps, 0.05) << "pixel by pixel it hardly changes";
  EXPECT_EQ(OffsetError({}, random).At({10.0, 10.0}), 0.0);
}

// A surface 1 m away beside one 1.2 m away.
std::vector<double> Step() {
  std::vector<double> depths_m(200, 1.0);
  std::fill(depths_m.begin() + 100, depths_m.end(), 1.2);
  return depths_m;
}

TEST(MatchPatches, ChangesNothingUnlessAsked) {
  std::mt19937_64 random(1);
  EXPECT_EQ(MatchPatches(Step(), {}, random), Step());
}

TEST(MatchPatches, NowAndThenMixesTheSidesOfAJump) {
  FaultOptions faults;
  faults.patch_px = 3.0;
  int mixed = 0;
  for (uint64_t seed = 0; seed < 100; ++seed) {
    std::mt19937_64 random(seed);
    const std::vector<double> seen_m = MatchPatches(Step(), faults, random);
    for (size_t i = 0; i < seen_m.size(); ++i) {
      if (std::abs(seen_m[i] - (i < 100 ? 1.0 : 1.2)) > 1e-12) ++mixed;
      if (i < 97 || i >= 103) {
        EXPECT_NEAR(seen_m[i], i < 100 ? 1.0 : 1.2, 1e-12);
      }
    }
  }
  EXPECT_GT(mixed, 3);
  EXPECT_LT(mixed, 40);
}

TEST(MatchPatches, MovesEachEdgeByADrawOfItsOwn) {
  FaultOptions faults;
  faults.edge_px = 2.0;
  double sum = 0.0, squares = 0.0;
  constexpr int kDraws = 400;
  std::mt19937_64 random(1);
  for (int draw = 0; draw < kDraws; ++draw) {
    const std::vector<double> seen_m = MatchPatches(Step(), faults, random);
    const auto near = std::count(seen_m.begin(), seen_m.end(), 1.0);
    EXPECT_EQ(near + std::count(seen_m.begin(), seen_m.end(), 1.2), 200);
    EXPECT_TRUE(std::is_sorted(seen_m.begin(), seen_m.end()));
    sum += static_cast<double>(near - 100);
    squares += std::pow(static_cast<double>(near - 100), 2);
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.3);
  EXPECT_NEAR(std::sqrt(squares / kDraws), 2.0, 0.25);
}

TEST(MatchPatches, LosesUpToSoManyLinesBesideAnEdge) {
  FaultOptions faults;
  faults.shadow_px = 3.0;
  int most = 0;
  std::mt19937_64 random(1);
  for (int draw = 0; draw < 100; ++draw) {
    const std::vector<double> seen_m = MatchPatches(Step(), faults, random);
    for (size_t i = 0; i < seen_m.size(); ++i) {
      if (i < 97 || i >= 103) {
        EXPECT_EQ(seen_m[i], i < 100 ? 1.0 : 1.2);
      }
    }
    const auto lost =
        std::count_if(seen_m.begin(), seen_m.end(), [](double z) { return std::isinf(z); });
    most = std::max(most, static_cast<int>(lost));
  }
  EXPECT_EQ(most, 6);
}

TEST(MatchPatches, LosesWhatIsSteepButNoJump) {
  std::vector<double> ramp_m = Step();
  for (size_t i = 0; i < 11; ++i) ramp_m[40 + i] = 1.0 - 0.002 * static_cast<double>(i);
  std::fill(ramp_m.begin() + 51, ramp_m.begin() + 100, 0.98);
  FaultOptions faults;
  faults.steepest_m = 0.0015;
  std::mt19937_64 random(1);
  const std::vector<double> seen_m = MatchPatches(ramp_m, faults, random);
  for (size_t i = 0; i < seen_m.size(); ++i) {
    EXPECT_EQ(std::isinf(seen_m[i]), i >= 40 && i <= 50) << i;
  }
}

}  // namespace
}  // namespace geon::evaluation
