#include "evaluation/stripe_noise.h"

#include <cmath>

namespace geon::evaluation {
namespace {

constexpr double kSpeckleLength_px = 4.0;
constexpr double kOutlierReach_px = 20.0;

}  // namespace

std::vector<StripeError> StripeErrors(size_t lines, const FaultOptions& faults,
                                      std::mt19937_64& random) {
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> uniform;
  const double memory = std::exp(-1.0 / kSpeckleLength_px);
  const double refresh = std::sqrt(1.0 - memory * memory);
  double speckle = gauss(random);
  std::vector<StripeError> errors(lines);
  for (StripeError& error : errors) {
    error.offset_px = faults.noise_px * gauss(random);
    if (faults.speckle_px > 0.0) {
      speckle = memory * speckle + refresh * gauss(random);
      error.offset_px += faults.speckle_px * speckle;
    }
    if (faults.outliers_1 > 0.0 && uniform(random) < faults.outliers_1) {
      error.offset_px = kOutlierReach_px * (2.0 * uniform(random) - 1.0);
    }
    error.missing = faults.dropout_1 > 0.0 && uniform(random) < faults.dropout_1;
  }
  return errors;
}

}  // namespace geon::evaluation
