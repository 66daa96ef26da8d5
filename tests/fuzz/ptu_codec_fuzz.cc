// Any bytes, in any pieces, into the reader of the pan-tilt unit's answers, and into its driver.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "device/ptu_codec.h"
#include "device/ptu_driver.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  geon::device::PtuReader reader;
  geon::device::PtuDriver driver;
  driver.Connected(0.0);
  driver.SetTarget({.pan_rad = 0.3, .tilt_rad = -0.3, .command_id = 1});
  double time_s = 0.0;
  // The first byte of each piece is its length and the pause after it.
  for (size_t at = 0; at < bytes.size();) {
    const size_t length = 1 + static_cast<uint8_t>(bytes[at]) % 32;
    const std::string_view piece = bytes.substr(at + 1, length);
    reader.Push(piece);
    while (const auto line = reader.Next()) {
      (void)geon::device::ParsePtuCount(line->text);
      (void)geon::device::ParsePtuNumber(line->text);
    }
    time_s += 0.01 * static_cast<double>(static_cast<uint8_t>(bytes[at]) / 8);
    (void)driver.Step(time_s, piece);
    at += 1 + length;
  }
  (void)reader.TakeUnfinished();
  return 0;
}
