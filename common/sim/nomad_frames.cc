#include "sim/nomad_frames.h"

#include <cstdlib>
#include <optional>

#include "base/contracts.h"

namespace geon::sim {
namespace {

constexpr uint8_t kStart = 0x01;
constexpr uint8_t kEnd = 0x5c;

uint8_t Checksum(std::span<const uint8_t> bytes) {
  unsigned sum = 0;
  for (const uint8_t byte : bytes) sum += byte;
  return static_cast<uint8_t>(sum & 0xff);
}

}  // namespace

std::vector<uint8_t> EncodeNomadFrame(const NomadFrame& frame) {
  const size_t length = frame.payload.size() + 2;  // type and checksum
  Require(length < 0x10000, "payload too long for a frame");
  std::vector<uint8_t> bytes;
  bytes.reserve(length + 4);
  bytes.push_back(kStart);
  AppendNomadUnsigned(static_cast<int>(length), &bytes);
  bytes.push_back(frame.type);
  for (const uint8_t byte : frame.payload) bytes.push_back(byte);
  bytes.push_back(Checksum(bytes));
  bytes.push_back(kEnd);
  return bytes;
}

int NomadSigned(std::span<const uint8_t> payload, size_t offset) {
  const int magnitude = NomadUnsigned(payload, offset) & 0x7fff;
  return (payload[offset + 1] & 0x80) != 0 ? -magnitude : magnitude;
}

int NomadUnsigned(std::span<const uint8_t> payload, size_t offset) {
  Require(offset + 1 < payload.size(), "number lies outside the payload");
  return payload[offset] | (payload[offset + 1] << 8);
}

void AppendNomadSigned(int value, std::vector<uint8_t>* payload) {
  const int magnitude = std::min(std::abs(value), 0x7fff);
  AppendNomadUnsigned(value < 0 ? magnitude | 0x8000 : magnitude, payload);
}

void AppendNomadUnsigned(int value, std::vector<uint8_t>* payload) {
  payload->push_back(static_cast<uint8_t>(value & 0xff));
  payload->push_back(static_cast<uint8_t>((value >> 8) & 0xff));
}

void AppendNomadUnsigned32(uint32_t value, std::vector<uint8_t>* payload) {
  for (int shift = 0; shift < 32; shift += 8) {
    payload->push_back(static_cast<uint8_t>((value >> shift) & 0xff));
  }
}

std::vector<NomadFrame> NomadFrameReader::Push(uint8_t byte) {
  buffer_.push_back(byte);
  std::vector<NomadFrame> frames;
  while (!buffer_.empty()) {
    if (buffer_[0] != kStart) {
      buffer_.erase(buffer_.begin());
      continue;
    }
    if (buffer_.size() < 3) break;
    const size_t length = buffer_[1] | (static_cast<size_t>(buffer_[2]) << 8);
    if (length < 2 || length + 4 > kLongestFrame) {
      buffer_.erase(buffer_.begin());
      continue;
    }
    const size_t whole = length + 4;
    if (buffer_.size() < whole) break;
    if (buffer_[whole - 1] != kEnd) {
      buffer_.erase(buffer_.begin());
      continue;
    }
    const std::span<const uint8_t> bytes(buffer_.data(), whole);
    NomadFrame frame{buffer_[3], {bytes.begin() + 4, bytes.end() - 2}};
    if (Checksum(bytes.first(whole - 2)) != bytes[whole - 2]) {
      frame = {static_cast<uint8_t>(NomadType::kNak), {}};
    }
    frames.push_back(std::move(frame));
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(whole));
  }
  return frames;
}

namespace {

size_t PayloadSize(NomadType type) {
  switch (type) {
    case NomadType::kAcceleration:
    case NomadType::kSpeed:
    case NomadType::kMoveRelative:
    case NomadType::kMoveAbsolute:
    case NomadType::kVelocity:
      return 6;
    case NomadType::kMask:
      return 7;
    case NomadType::kDefinePosition:
    case NomadType::kDefineAngles:
    case NomadType::kWaitStop:
      return 4;
    case NomadType::kConfigureInfrared:
    case NomadType::kConfigureSonar:
      return 17;
    case NomadType::kConfigureCompass:
    case NomadType::kConfigureTimeout:
      return 1;
    case NomadType::kConfigureLaser:
      return 6;
    case NomadType::kConfigureScan:
      return 3;
    case NomadType::kMoveServos:
      return 12;
    default:
      return 0;
  }
}

}  // namespace

bool WellFormed(const NomadFrame& frame) {
  const auto type = static_cast<NomadType>(frame.type);
  if (type == NomadType::kTalk) return !frame.payload.empty() && frame.payload.back() == 0;
  return frame.payload.size() == PayloadSize(type);
}

}  // namespace geon::sim
