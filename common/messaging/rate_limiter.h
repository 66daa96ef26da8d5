#pragma once

#include <cstdint>
#include <optional>

namespace geon::messaging {

// Lets one event per period through and counts the others, so that a warning that repeats a
// thousand times a second is said once, with the number.
class RateLimiter {
 public:
  explicit RateLimiter(double period_s = 5.0) : period_s_(period_s) {}

  // At a time that never runs backwards: how many events this one stands for (itself and those held
  // back since the last one let through), or nothing when it is held back.
  std::optional<int64_t> Pass(double now_s) {
    ++held_back_;
    if (next_s_ && now_s < *next_s_) return std::nullopt;
    next_s_ = now_s + period_s_;
    const int64_t events = held_back_;
    held_back_ = 0;
    return events;
  }

 private:
  double period_s_;
  std::optional<double> next_s_;
  int64_t held_back_ = 0;
};

}  // namespace geon::messaging
