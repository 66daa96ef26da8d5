// Any bytes, in any pieces, into the reader of the base's frames, and into its driver.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "device/nomad_codec.h"
#include "device/nomad_driver.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  geon::device::NomadReader reader;
  geon::device::NomadDriver driver;
  driver.Connected(0.0);
  double time_s = 0.0;
  // The first byte of each piece is its length and the pause after it.
  for (size_t at = 0; at < bytes.size();) {
    const size_t length = 1 + static_cast<uint8_t>(bytes[at]) % 64;
    const std::string_view piece = bytes.substr(at + 1, length);
    reader.Push(piece);
    while (const auto frame = reader.Next()) {
      // What was read as a frame is one: writing it again gives bytes that read the same.
      geon::device::NomadReader again;
      again.Push(geon::device::EncodeNomadFrame(frame->type, frame->payload));
      const auto copy = again.Next();
      if (!copy || copy->payload != frame->payload || copy->type != frame->type) std::abort();
      (void)geon::device::DecodeNomadState(frame->payload, {});
    }
    time_s += 0.01 * static_cast<double>(static_cast<uint8_t>(bytes[at]) / 8);
    (void)driver.Step(time_s, piece);
    driver.Drive(0.2, 0.1);
    at += 1 + length;
  }
  return 0;
}
