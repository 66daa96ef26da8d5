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

TEST(MatchPatches, DisplacesTheEdgeAndNowAndThenMixesItsSides) {
  FaultOptions faults;
  faults.patch_px = 3.0;
  faults.edge_px = 2.0;
  int displaced = 0, mixed = 0;
  for (uint64_t seed = 0; seed < 100; ++seed) {
    std::mt19937_64 random(seed);
    const std::vector<double> seen_m = MatchPatches(Step(), faults, random);
    for (size_t i = 0; i < seen_m.size(); ++i) {
      if (seen_m[i] != 1.0 && seen_m[i] != 1.2) ++mixed;
      if (seen_m[i] == (i < 100 ? 1.2 : 1.0)) ++displaced;
      if (i < 80 || i >= 120) {
        EXPECT_NEAR(seen_m[i], i < 100 ? 1.0 : 1.2, 1e-12);
      }
    }
  }
  EXPECT_GT(displaced, 50);
  EXPECT_GT(mixed, 3);
  EXPECT_LT(mixed, 100);
}

TEST(MatchPatches, LosesTheLinesBesideAJump) {
  FaultOptions faults;
  faults.shadow_px = 3.0;
  std::mt19937_64 random(1);
  const std::vector<double> seen_m = MatchPatches(Step(), faults, random);
  EXPECT_EQ(std::count_if(seen_m.begin(), seen_m.end(), [](double z) { return std::isinf(z); }), 6);
  EXPECT_TRUE(std::isinf(seen_m[97]) && std::isinf(seen_m[102]));
}

}  // namespace
}  // namespace geon::evaluation
