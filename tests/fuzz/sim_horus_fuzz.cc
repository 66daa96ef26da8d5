// Any bytes at any pace into the simulated laser board: after Ctrl-X it is dark, and answers each
// line once.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "sim/horus_emulator.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  geon::sim::HorusEmulator board;
  double now_s = 1.0;
  for (size_t at = 0; at < size && at < 4096;) {
    const size_t count = std::min<size_t>(1 + data[at] % 64, size - at);
    board.Receive({data + at, count}, now_s);
    now_s += 0.0005 * data[at];
    board.Advance(now_s);
    at += count;
  }
  const auto ask = [&](const std::string& text) {
    board.Receive({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, now_s);
    now_s += 0.5;
    board.Advance(now_s);
    const auto bytes = board.Transmit(now_s);
    return std::string(bytes.begin(), bytes.end());
  };
  ask("\x18");
  const auto& lasers = board.lasers();
  if (std::any_of(lasers.begin(), lasers.end(), [](bool on) { return on; })) std::abort();
  ask("$X\n");
  if (ask("M71T1\n") != "ok\r\n" || !board.lasers()[0]) std::abort();
  return 0;
}
