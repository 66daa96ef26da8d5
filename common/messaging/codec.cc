#include "messaging/codec.h"

#include <exception>
#include <string>

#include "base/contracts.h"
#include "messaging/message_schema.h"
#include "messaging/wire.h"

namespace geon::messaging {
namespace {

template <typename T>
using WireType = decltype(ToWire(std::declval<T>()));

uint64_t BigEndian(std::span<const uint8_t> bytes) {
  uint64_t bits = 0;
  for (const uint8_t byte : bytes) bits = bits << 8 | byte;
  return bits;
}

std::string NameOf(uint64_t fingerprint) {
  const std::string_view name = TypeNameOf(fingerprint);
  if (!name.empty()) return "geon." + std::string(name);
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "an unknown type (fingerprint 0x";
  for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[fingerprint >> shift & 15u];
  return text + ", a publisher built from other types?)";
}

}  // namespace

std::optional<MessageHead> ReadMessageHead(std::span<const uint8_t> bytes) {
  if (bytes.size() < 20) return std::nullopt;
  return MessageHead{BigEndian(bytes.first(8)),
                     static_cast<int64_t>(BigEndian(bytes.subspan(8, 8))),
                     static_cast<int32_t>(BigEndian(bytes.subspan(16, 4)))};
}

Status CheckFingerprint(uint64_t found, uint64_t expected) {
  if (found == expected) return Status::Ok();
  return Status::Error("expected " + NameOf(expected) + ", found " + NameOf(found));
}

template <typename T>
uint64_t WireFingerprint() {
  return static_cast<uint64_t>(WireType<T>::getHash());
}

template <typename T>
std::vector<uint8_t> Encode(const T& value) {
  const WireType<T> message = ToWire(value);
  std::vector<uint8_t> bytes(static_cast<size_t>(message.getEncodedSize()));
  const int written = message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  Require(written == static_cast<int>(bytes.size()), "LCM could not encode a message");
  return bytes;
}

template <typename T>
Result<T> Decode(std::span<const uint8_t> bytes) {
  const std::optional<MessageHead> head = ReadMessageHead(bytes);
  if (!head) return Status::Error("only " + std::to_string(bytes.size()) + " bytes");
  if (Status status = CheckFingerprint(head->fingerprint, WireFingerprint<T>()); !status.ok()) {
    return status;
  }
  // The generated decoder allocates what a count says before it looks whether the elements are
  // there.
  if (Status status = CheckMessage(WireType<T>::getTypeName(), bytes); !status.ok()) return status;
  try {
    WireType<T> message;
    const int used = message.decode(bytes.data(), 0, static_cast<int>(bytes.size()));
    if (used < 0) return Status::Error("LCM cannot decode it");
    return FromWire(message);
  } catch (const std::exception& error) {
    return Status::Error(std::string("decoding threw: ") + error.what());
  }
}

#define GEON_MESSAGE(T)                              \
  template uint64_t WireFingerprint<T>();            \
  template std::vector<uint8_t> Encode<T>(const T&); \
  template Result<T> Decode<T>(std::span<const uint8_t> bytes);
GEON_MESSAGE(sensor::Image)
GEON_MESSAGE(sensor::Stripe)
GEON_MESSAGE(sensor::ScanCommand)
GEON_MESSAGE(sensor::ScanPlan)
GEON_MESSAGE(sensor::RangeProfile)
GEON_MESSAGE(sensor::GeonVerdict)
GEON_MESSAGE(sensor::PtuState)
GEON_MESSAGE(sensor::PtuCommand)
GEON_MESSAGE(sensor::BaseState)
GEON_MESSAGE(sensor::BaseCommand)
GEON_MESSAGE(sensor::SonarScan)
GEON_MESSAGE(sensor::BumperState)
GEON_MESSAGE(sensor::InfraredScan)
GEON_MESSAGE(sensor::LaserState)
GEON_MESSAGE(sensor::PlannerState)
GEON_MESSAGE(sensor::TargetMask)
GEON_MESSAGE(sensor::TargetView)
GEON_MESSAGE(sensor::Health)
GEON_MESSAGE(sensor::Session)
#undef GEON_MESSAGE

}  // namespace geon::messaging
