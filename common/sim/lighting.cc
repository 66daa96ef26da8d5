#include "sim/lighting.h"

#include <cmath>

namespace geon::sim {
namespace {

// Planck's law up to a constant factor.
double Planck(double wavelength_m, double kelvin) {
  constexpr double kSecondRadiationConstant_mK = 0.01438777;
  return 1.0 / (std::pow(wavelength_m, 5) *
                (std::exp(kSecondRadiationConstant_mK / (wavelength_m * kelvin)) - 1.0));
}

}  // namespace

Eigen::Vector3f BlackBodyColor(double kelvin) {
  constexpr double kWhiteBalance_K = 4000.0;
  constexpr double kWavelengths_m[3] = {600e-9, 540e-9, 450e-9};  // middle of red, green and blue
  Eigen::Vector3d gain;
  for (int c = 0; c < 3; ++c) {
    gain[c] = Planck(kWavelengths_m[c], kelvin) / Planck(kWavelengths_m[c], kWhiteBalance_K);
  }
  return (gain / gain[1]).cast<float>();
}

}  // namespace geon::sim
