#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "sim/serial_device.h"

namespace geon {

// A driver and an emulated device at the two ends of one line, in virtual time.
template <typename Driver>
class PairedLine {
 public:
  static constexpr double kStep_s = 0.005;  // as a daemon's loop turns

  PairedLine(Driver* driver, sim::SerialDevice* device) : driver_(driver), device_(device) {
    Open();
  }

  void Open() {
    device_->PortOpened(time_s_);
    driver_->Connected(time_s_);
    open_ = true;
  }
  void Close() {
    driver_->Disconnected(time_s_);
    open_ = false;
  }
  void Run(double duration_s) {
    RunUntil([] { return false; }, duration_s);
  }
  // True as soon as the condition holds; false when it did not within the time.
  bool RunUntil(const std::function<bool()>& condition, double limit_s) {
    for (const double end_s = time_s_ + limit_s; time_s_ < end_s;) {
      if (condition()) return true;
      Step();
    }
    return condition();
  }
  // Each way, some random bytes before what was really said.
  void Garble(std::mt19937* random, int longest) {
    to_device_ += Noise(random, longest);
    to_driver_ += Noise(random, longest);
  }

  double time_s() const { return time_s_; }

 private:
  void Step() {
    time_s_ += kStep_s;
    const std::vector<uint8_t> heard(to_device_.begin(), to_device_.end());
    to_device_.clear();
    device_->Receive(heard, time_s_);
    device_->Advance(time_s_);
    const std::vector<uint8_t> said = device_->Transmit(time_s_);
    to_driver_.append(said.begin(), said.end());
    to_device_ = open_ ? driver_->Step(time_s_, to_driver_) : std::string();
    to_driver_.clear();
  }
  static std::string Noise(std::mt19937* random, int longest) {
    std::string noise((*random)() % static_cast<unsigned>(longest + 1), '\0');
    for (char& byte : noise) byte = static_cast<char>((*random)());
    return noise;
  }

  Driver* driver_;
  sim::SerialDevice* device_;
  bool open_ = false;
  double time_s_ = 0.0;
  std::string to_device_;
  std::string to_driver_;
};

}  // namespace geon
