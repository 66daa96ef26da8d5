#include "sim/paced_bytes.h"

#include <algorithm>

#include "base/contracts.h"

namespace geon::sim {

PacedBytes::PacedBytes(int baud) : byte_time_s_(10.0 / baud) {
  Require(baud > 0, "baud rate must be positive");
}

void PacedBytes::Push(std::span<const uint8_t> bytes, double time_s) {
  for (const uint8_t byte : bytes) {
    last_arrival_s_ = std::max(last_arrival_s_, time_s) + byte_time_s_;
    bytes_.push_back({byte, last_arrival_s_});
  }
}

std::optional<uint8_t> PacedBytes::Pop(double time_s) {
  if (bytes_.empty() || bytes_.front().time_s > time_s) return std::nullopt;
  const uint8_t byte = bytes_.front().byte;
  bytes_.pop_front();
  return byte;
}

std::vector<uint8_t> PacedBytes::PopAll(double time_s) {
  std::vector<uint8_t> arrived;
  while (const auto byte = Pop(time_s)) arrived.push_back(*byte);
  return arrived;
}

}  // namespace geon::sim
