#pragma once

#include <functional>
#include <string>

namespace geon::device {

// Runs a driver against a scripted device in virtual time: what one says in a step, the other hears
// in the next. The device is a function of the time and of what it heard.
template <typename Driver>
class VirtualLine {
 public:
  using Device = std::function<std::string(double time_s, const std::string& heard)>;

  VirtualLine(Driver* driver, Device device) : driver_(driver), device_(std::move(device)) {
    driver_->Connected(time_s_);
  }

  void Run(double duration_s) {
    RunUntil([] { return false; }, duration_s);
  }
  // True as soon as the condition holds; false when it did not within the time.
  bool RunUntil(const std::function<bool()>& condition, double limit_s) {
    for (const double end_s = time_s_ + limit_s; time_s_ < end_s;) {
      if (condition()) return true;
      time_s_ += kStep_s;
      const std::string said = driver_->Step(time_s_, to_driver_);
      to_driver_ = device_(time_s_, said);
      traffic_ += said;
    }
    return condition();
  }
  // Puts bytes on the driver's end of the line, as noise or a spontaneous device would.
  void Inject(const std::string& bytes) { to_driver_ += bytes; }

  double time_s() const { return time_s_; }
  // All the driver has said since last asked.
  std::string TakeTraffic() { return std::exchange(traffic_, {}); }

  static constexpr double kStep_s = 0.005;

 private:
  Driver* driver_;
  Device device_;
  double time_s_ = 100.0;
  std::string to_driver_;
  std::string traffic_;
};

}  // namespace geon::device
