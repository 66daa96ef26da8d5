#pragma once

#include <chrono>
#include <iostream>
#include <string>
#include <utility>

namespace geon::cli {

// Says on stderr how far long work is: nothing for two seconds, then once a second.
class Progress {
 public:
  explicit Progress(std::string command) : command_(std::move(command)) {}

  void Say(double fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::seconds(1);
    std::cerr << command_ << ": " << static_cast<int>(100.0 * fraction) << " %\n";
  }

 private:
  std::string command_;
  std::chrono::steady_clock::time_point next_ =
      std::chrono::steady_clock::now() + std::chrono::seconds(2);
};

}  // namespace geon::cli
