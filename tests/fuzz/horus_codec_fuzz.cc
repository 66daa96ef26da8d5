// Any bytes, in any pieces, into the reader of the laser board's lines, and into its driver, which
// must never ask for both lasers at once.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "device/horus_codec.h"
#include "device/laser_driver.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  geon::device::HorusReader reader;
  geon::device::LaserDriver driver;
  driver.Connected(0.0);
  bool lit[2] = {false, false};
  double time_s = 0.0;
  // The first byte of each piece is its length, the pause after it and the laser wanted.
  for (size_t at = 0; at < bytes.size();) {
    const auto head = static_cast<uint8_t>(bytes[at]);
    const size_t length = 1 + head % 32;
    const std::string_view piece = bytes.substr(at + 1, length);
    reader.Push(piece);
    while (reader.Next()) {
    }
    time_s += 0.02 * static_cast<double>(head / 8);
    driver.Request(static_cast<geon::sensor::Laser>(head % 3));
    const std::string said = driver.Step(time_s, piece);
    for (const int laser : {0, 1}) {
      const std::string number = std::to_string(laser + 1);
      if (said == "M71T" + number + "\r\n") lit[laser] = true;
      if (said == "M70T" + number + "\r\n") lit[laser] = false;
    }
    if (said.starts_with('\x18')) lit[0] = lit[1] = false;
    if (lit[0] && lit[1]) std::abort();
    at += 1 + length;
  }
  return 0;
}
