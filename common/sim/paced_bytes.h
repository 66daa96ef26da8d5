#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

namespace geon::sim {

// One direction of a serial line: a byte arrives ten bit times (8N1) after it, or the byte before
// it, was sent.
class PacedBytes {
 public:
  explicit PacedBytes(int baud);

  void Push(std::span<const uint8_t> bytes, double time_s);
  // The next byte that has arrived by `time_s`.
  std::optional<uint8_t> Pop(double time_s);
  // All bytes that have arrived by `time_s`.
  std::vector<uint8_t> PopAll(double time_s);
  void Clear() { bytes_.clear(); }
  bool empty() const { return bytes_.empty(); }
  // When the last byte pushed so far arrives.
  double last_arrival_s() const { return last_arrival_s_; }

 private:
  struct Arrival {
    uint8_t byte;
    double time_s;
  };
  double byte_time_s_;
  double last_arrival_s_ = 0.0;
  std::deque<Arrival> bytes_;
};

}  // namespace geon::sim
