#pragma once

#include <algorithm>

namespace geon::device {

// When to try again: waits that double, from `first_s` up to `longest_s`.
class BackOff {
 public:
  BackOff(double first_s, double longest_s)
      : first_s_(first_s), longest_s_(longest_s), wait_s_(first_s) {}
  void Failed(double time_s) {
    next_s_ = time_s + wait_s_;
    wait_s_ = std::min(2.0 * wait_s_, longest_s_);
  }
  void Succeeded() { wait_s_ = first_s_; }
  bool Due(double time_s) const { return time_s >= next_s_; }

 private:
  double first_s_;
  double longest_s_;
  double wait_s_;
  double next_s_ = 0.0;
};

}  // namespace geon::device
