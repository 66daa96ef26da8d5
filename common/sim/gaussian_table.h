#pragma once

#include <array>
#include <cstdint>

namespace geon::sim {

// The standard normal distribution as 65536 equally likely numbers: one look-up a sample, because a
// frame takes a million of them.
class GaussianTable {
 public:
  static float At(uint16_t index) { return Table()[index]; }
  static const std::array<float, 65536>& Table();
};

}  // namespace geon::sim
