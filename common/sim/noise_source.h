#pragma once

#include <cmath>
#include <cstdint>

#include "base/angles.h"

namespace geon::sim {

// Seeded random numbers, the same on every machine and with every library (splitmix64, Box-Muller).
class NoiseSource {
 public:
  explicit NoiseSource(uint64_t seed) : state_(seed) {}

  uint64_t Bits() {
    uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  // In [0, 1).
  double Uniform() { return static_cast<double>(Bits() >> 11) * 0x1.0p-53; }
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  bool Chance(double probability_1) { return Uniform() < probability_1; }
  // Mean 0, standard deviation 1.
  double Gaussian() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
    return radius * std::cos(2.0 * kPi * Uniform());
  }

 private:
  uint64_t state_;
};

}  // namespace geon::sim
