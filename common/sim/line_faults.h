#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "sim/noise_source.h"

namespace geon::sim {

// What is wrong with a serial line, for practising recovery. All off by default.
struct LineFaultOptions {
  uint64_t seed = 1;
  double delay_s = 0.0;    // everything the device says comes so much later
  double drop_1 = 0.0;     // probability that a byte is lost, either way
  double corrupt_1 = 0.0;  // probability that a byte has a bit flipped, either way
  double split_1 = 0.0;    // probability of a pause after a byte of the device
  double split_pause_s = 0.05;
  double garbage_1 = 0.0;  // probability that noise comes before what the device says
  int garbage_bytes = 5;
  double silent_from_s = std::numeric_limits<double>::infinity();  // device says nothing ...
  double silent_until_s = std::numeric_limits<double>::infinity();
  double reboot_at_s = std::numeric_limits<double>::infinity();  // device loses power for a moment
};

// Reads "delay_s=0.05,corrupt_1=0.01,silent_from_s=10,silent_until_s=12": the names above, in any
// order, an empty text for no faults. An error names the word that is wrong.
Result<LineFaultOptions> ParseLineFaults(std::string_view text);

// Sits between a device and its line and spoils what passes, in virtual time.
class LineFaults {
 public:
  explicit LineFaults(const LineFaultOptions& options);

  // What the device hears of what the host sent.
  std::vector<uint8_t> ToDevice(std::span<const uint8_t> bytes);
  // Takes what the device says now; gives what reaches the host now.
  std::vector<uint8_t> ToHost(std::span<const uint8_t> bytes, double time_s);
  // True once, when the device is to be power-cycled.
  bool TakeReboot(double time_s);

 private:
  struct Arrival {
    uint8_t byte;
    double time_s;
  };
  void Queue(uint8_t byte, double time_s);

  LineFaultOptions options_;
  NoiseSource noise_;
  bool rebooted_ = false;
  double last_arrival_s_ = 0.0;
  std::deque<Arrival> queue_;
};

}  // namespace geon::sim
