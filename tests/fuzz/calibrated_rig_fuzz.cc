#include <cstddef>
#include <cstdint>
#include <string>

#include "config/calibrated_rig_file.h"
#include "config/text_file.h"

// Any text, with and without the hash that belongs to it: refused with a reason, or a rig that
// writes itself again.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::string text(reinterpret_cast<const char*>(data), size);
  for (const bool hashed : {false, true}) {
    if (hashed) {
      text += "\n";
      text += "fnv1a: \"" + geon::config::ContentHash(text) + "\"\n";
    }
    const auto parsed = geon::config::ParseCalibratedRig(text, "rig.yaml", {});
    if (!parsed.ok()) {
      if (parsed.message().empty()) __builtin_trap();
      continue;
    }
    const std::string written = geon::config::SerializeCalibratedRig(*parsed);
    if (!geon::config::ParseCalibratedRig(written, "rig.yaml", {}).ok()) __builtin_trap();
  }
  return 0;
}
