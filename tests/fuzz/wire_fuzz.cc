// Any datagram, as the payload of every message type: decoded or refused, never a crash, a throw or
// a large allocation.
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "device/frame_message.h"
#include "messaging/codec.h"
#include "messaging/message_schema.h"
#include "sensor/base.h"
#include "sensor/geon_verdict.h"
#include "sensor/health.h"
#include "sensor/laser_state.h"
#include "sensor/planner_state.h"
#include "sensor/ptu.h"
#include "sensor/scan_set.h"
#include "sensor/stripe.h"
#include "sensor/target_mask.h"
#include "sensor/target_view.h"

namespace {

using namespace geon;  // NOLINT(google-build-using-namespace): a list of types follows

// What decodes must encode and decode again.
template <typename T>
void Try(std::vector<uint8_t> bytes) {
  const uint64_t fingerprint = messaging::WireFingerprint<T>();
  for (size_t i = 0; i < 8; ++i) bytes[i] = static_cast<uint8_t>(fingerprint >> (56 - 8 * i));
  const Result<T> value = messaging::Decode<T>(bytes);
  (void)messaging::MessageToJson(bytes);
  if (value.ok() && !messaging::Decode<T>(messaging::Encode(*value)).ok()) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  std::vector<uint8_t> bytes(8 + size);
  std::copy(data, data + size, bytes.begin() + 8);
  (void)messaging::MessageToJson(std::span(data, size));
  Try<sensor::Image>(bytes);
  Try<sensor::Stripe>(bytes);
  Try<sensor::ScanCommand>(bytes);
  Try<sensor::ScanPlan>(bytes);
  Try<sensor::RangeProfile>(bytes);
  Try<sensor::GeonVerdict>(bytes);
  Try<sensor::PtuState>(bytes);
  Try<sensor::PtuCommand>(bytes);
  Try<sensor::BaseState>(bytes);
  Try<sensor::BaseCommand>(bytes);
  Try<sensor::SonarScan>(bytes);
  Try<sensor::BumperState>(bytes);
  Try<sensor::InfraredScan>(bytes);
  Try<sensor::LaserState>(bytes);
  Try<sensor::PlannerState>(bytes);
  Try<sensor::TargetMask>(bytes);
  Try<sensor::TargetView>(bytes);
  Try<sensor::Health>(bytes);
  Try<sensor::Session>(bytes);
  // And as a frame of a camera socket: half header, half pixels.
  const std::string_view text(reinterpret_cast<const char*>(data), size / 2);
  (void)device::ParseFrame(text, std::span(data + size / 2, size - size / 2));
  return 0;
}
