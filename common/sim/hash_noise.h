#pragma once

#include <cstdint>

namespace geon::sim {

// Random numbers that belong to a place instead of to a sequence: the same key gives the same
// number in any order of asking (finaliser of splitmix64).
constexpr uint64_t HashMix(uint64_t z) {
  z += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}
constexpr uint64_t HashMix(uint64_t seed, uint64_t a) { return HashMix(HashMix(seed) ^ a); }

// In [0, 1).
constexpr float HashUniform(uint64_t seed, int32_t a, int32_t b) {
  const uint64_t place =
      static_cast<uint64_t>(static_cast<uint32_t>(a)) << 32U | static_cast<uint32_t>(b);
  return static_cast<float>(HashMix(seed, place) >> 40U) * 0x1.0p-24F;
}

}  // namespace geon::sim
