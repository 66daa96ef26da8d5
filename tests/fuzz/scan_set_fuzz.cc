#include <cstddef>
#include <cstdint>
#include <string>

#include "config/scan_set_json.h"
#include "recognition/recognize_geon.h"

// Any bytes: refused with a reason, or a scan set that survives a round trip and gets a verdict.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto scan = geon::config::ParseScanSet(text, "fuzz");
  if (!scan.ok()) {
    if (scan.message().empty()) __builtin_trap();
    return 0;
  }
  const std::string written = geon::config::SerializeScanSet(*scan);
  const auto again = geon::config::ParseScanSet(written, "again");
  if (!again.ok() || geon::config::SerializeScanSet(*again) != written) __builtin_trap();
  geon::recognition::RecognizeGeon(*scan, {});
  return 0;
}
