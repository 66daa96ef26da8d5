#include "evaluation/stripe_noise.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace geon::evaluation
