#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace geon::messaging {

// Bytes on the wire <-> plain data, for every message of the bus:
//   sensor:: Image Stripe ScanCommand ScanPlan RangeProfile GeonVerdict PtuState PtuCommand
//   BaseState BaseCommand SonarScan BumperState InfraredScan LaserState PlannerState TargetMask
//   TargetView Health Session.
// Other types do not link. Nobody outside this room needs the generated LCM types.

// A value that no message can carry (an image whose bytes do not match its size, say) breaks the
// contract.
template <typename T>
std::vector<uint8_t> Encode(const T& value);

// Trusts nothing: the fingerprint, every count against the bytes that are there, enumerations,
// array and image sizes. The message of an error names the type and the field.
template <typename T>
Result<T> Decode(std::span<const uint8_t> bytes);

// LCM's fingerprint of the type that carries T; and whether a message has it, told with the types'
// names.
template <typename T>
uint64_t WireFingerprint();
Status CheckFingerprint(uint64_t found, uint64_t expected);

// What every message starts with. Nothing if the bytes are too few.
struct MessageHead {
  uint64_t fingerprint = 0;
  int64_t utime = 0;
  int32_t seq = 0;
};
std::optional<MessageHead> ReadMessageHead(std::span<const uint8_t> bytes);

}  // namespace geon::messaging
