// Any bytes at any pace into the simulated pan-tilt unit: it stays within its stops, and once its
// longest job is done it answers again.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "sim/ptu_emulator.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  geon::sim::PtuEmulator ptu;
  double now_s = 0.5;
  for (size_t at = 0; at < size && at < 512;) {
    const size_t count = std::min<size_t>(1 + data[at] % 16, size - at);
    ptu.Receive({data + at, count}, now_s);
    now_s += 0.001 * data[at];
    ptu.Advance(now_s);
    ptu.Transmit(now_s);
    at += count;
  }
  constexpr std::string_view kWake = " _0 U0 CI H ED ";
  ptu.Receive({reinterpret_cast<const uint8_t*>(kWake.data()), kWake.size()}, now_s);
  bool answers = false;
  for (int i = 0; i < 60 && !answers; ++i) {
    now_s += 10.0;
    ptu.Advance(now_s);
    ptu.Transmit(now_s);
    constexpr std::string_view kAsk = "TX ";
    ptu.Receive({reinterpret_cast<const uint8_t*>(kAsk.data()), kAsk.size()}, now_s);
    ptu.Advance(now_s + 0.1);
    answers = !ptu.Transmit(now_s + 0.1).empty();
  }
  const bool within =
      ptu.pan_rad() > -2.9 && ptu.pan_rad() < 2.9 && ptu.tilt_rad() > -0.9 && ptu.tilt_rad() < 0.6;
  if (!answers || !within) std::abort();
  return 0;
}
