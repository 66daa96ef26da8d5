#include "device/nomad_codec.h"

#include <bit>
#include <cstdlib>
#include <string>

#include "base/contracts.h"

namespace geon::device {
namespace {

constexpr char kStart = 0x01;
constexpr char kEnd = 0x5c;
constexpr size_t kHeadSize = 3;  // start and length
constexpr size_t kShortest = 2;  // type and checksum
constexpr size_t kLongest = 300;
constexpr size_t kTrailSize = 1 + 4 + 2;  // motors, time, voltages

char Checksum(std::string_view bytes) {
  unsigned sum = 0;
  for (const char byte : bytes) sum += static_cast<uint8_t>(byte);
  return static_cast<char>(sum & 0xffU);
}

void AppendUnsigned16(int value, std::string* bytes) {
  Require(value >= 0 && value <= 0xffff, "16-bit field: " + std::to_string(value));
  *bytes += static_cast<char>(value & 0xff);
  *bytes += static_cast<char>(value >> 8);
}

std::string EncodeUnsigned(NomadType type, int first, int second, int third) {
  std::string payload;
  for (const int value : {first, second, third}) AppendUnsigned16(value, &payload);
  return EncodeNomadFrame(type, payload);
}

// Reads a payload whose length has been checked.
class Fields {
 public:
  explicit Fields(std::string_view bytes) : bytes_(bytes) {}
  uint8_t Byte() { return static_cast<uint8_t>(bytes_[next_++]); }
  int Signed() {
    const uint8_t low = Byte();
    return DecodeSignMagnitude(low, Byte());
  }

 private:
  std::string_view bytes_;
  size_t next_ = 0;
};

size_t InfraredSize(const NomadMask& mask) {
  return (static_cast<size_t>(std::popcount(mask.infrared)) + 1) / 2;
}

void ReadInfrared(const NomadMask& mask, Fields* fields, NomadState* state) {
  uint8_t byte = 0;
  bool low = true;
  for (size_t i = 0; i < state->infrared.size(); ++i) {
    if (!(mask.infrared >> i & 1)) continue;
    if (low) byte = fields->Byte();
    state->infrared[i] = low ? byte & 0x0f : byte >> 4;
    low = !low;
  }
}

}  // namespace

std::string EncodeNomadFrame(NomadType type, std::string_view payload) {
  const size_t length = payload.size() + kShortest;
  Require(length <= kLongest, "frame too long: " + std::to_string(length));
  std::string frame{kStart, static_cast<char>(length & 0xff), static_cast<char>(length >> 8),
                    static_cast<char>(type)};
  frame += payload;
  frame += Checksum(frame);
  frame += kEnd;
  return frame;
}

std::string EncodeSignMagnitude(int value) {
  const int magnitude = std::abs(value);
  Require(magnitude <= kNomadMaxMagnitude, "sign-magnitude field: " + std::to_string(value));
  return {static_cast<char>(magnitude & 0xff),
          static_cast<char>((magnitude >> 8) | (value < 0 ? 0x80 : 0))};
}

int DecodeSignMagnitude(uint8_t low, uint8_t high) {
  const int magnitude = (high & 0x7f) << 8 | low;
  return (high & 0x80) ? -magnitude : magnitude;
}

std::string EncodeVelocity(int translation, int steering, int turret) {
  return EncodeNomadFrame(NomadType::kVelocity, EncodeSignMagnitude(translation) +
                                                    EncodeSignMagnitude(steering) +
                                                    EncodeSignMagnitude(turret));
}

std::string EncodeAcceleration(int translation, int steering, int turret) {
  return EncodeUnsigned(NomadType::kAcceleration, translation, steering, turret);
}

std::string EncodeSpeed(int translation, int steering, int turret) {
  return EncodeUnsigned(NomadType::kSpeed, translation, steering, turret);
}

std::string EncodeMask(const NomadMask& mask) {
  const int group =
      (mask.bumper ? 0x01 : 0) | (mask.configuration ? 0x1e : 0) | (mask.velocity ? 0xe0 : 0);
  std::string payload;
  AppendUnsigned16(mask.infrared, &payload);
  AppendUnsigned16(mask.sonar, &payload);
  payload += static_cast<char>(group);
  payload += '\0';
  payload += static_cast<char>(mask.compass ? 1 : 0);
  return EncodeNomadFrame(NomadType::kMask, payload);
}

std::string EncodeTimeout(int timeout_s) {
  Require(timeout_s >= 0 && timeout_s <= 255, "CONF_TM takes 0 ... 255 s");
  return EncodeNomadFrame(NomadType::kTimeout, std::string(1, static_cast<char>(timeout_s)));
}

std::string EncodeSonarOrder(int rate, const std::array<int, sensor::kSonarCount>& order) {
  Require(rate >= 0 && rate <= 255, "CONF_SN takes a rate of 0 ... 255");
  std::string payload(1, static_cast<char>(rate));
  for (const int sonar : order) {
    Require((sonar >= 0 && sonar < sensor::kSonarCount) || sonar == 255,
            "CONF_SN takes sonars 0 ... 15, or 255 to end the list");
    payload += static_cast<char>(sonar);
  }
  return EncodeNomadFrame(NomadType::kSonarOrder, payload);
}

size_t NomadStateLength(const NomadMask& mask) {
  return InfraredSize(mask) + static_cast<size_t>(std::popcount(mask.sonar)) +
         (mask.bumper ? 3U : 0U) + (mask.configuration ? 8U : 0U) + (mask.velocity ? 6U : 0U) +
         (mask.compass ? 2U : 0U) + kTrailSize;
}

std::optional<NomadState> DecodeNomadState(std::string_view payload, const NomadMask& mask) {
  if (payload.size() != NomadStateLength(mask)) return std::nullopt;
  NomadState state;
  Fields fields(payload);
  ReadInfrared(mask, &fields, &state);
  for (size_t i = 0; i < state.sonar_in.size(); ++i) {
    if (mask.sonar >> i & 1) state.sonar_in[i] = fields.Byte();
  }
  if (mask.bumper) {  // 20 bits, most significant byte first
    uint32_t bits = 0;
    for (int i = 0; i < 3; ++i) bits = bits << 8 | fields.Byte();
    state.bumpers = bits & 0xfffffU;
  }
  if (mask.configuration) {
    auto& c = state.configuration.emplace();
    for (int* field : {&c.x, &c.y, &c.steer, &c.turret}) *field = fields.Signed();
  }
  if (mask.velocity) {
    auto& v = state.velocity.emplace();
    for (int* field : {&v.translation, &v.steer, &v.turret}) *field = fields.Signed();
  }
  if (mask.compass) state.compass = fields.Signed();
  state.motors = fields.Byte();
  for (unsigned shift = 0; shift < 32; shift += 8) {
    state.time_ms |= static_cast<uint32_t>(fields.Byte()) << shift;
  }
  state.cpu_volts_raw = fields.Byte();
  state.motor_volts_raw = fields.Byte();
  return state;
}

std::optional<NomadFrame> NomadReader::Next() {
  size_t begin = 0;
  std::optional<NomadFrame> frame;
  for (; begin < buffer_.size(); ++begin) {
    const std::string_view rest = std::string_view(buffer_).substr(begin);
    if (rest[0] != kStart) continue;
    if (rest.size() < kHeadSize) break;
    const size_t length =
        static_cast<uint8_t>(rest[1]) | static_cast<size_t>(static_cast<uint8_t>(rest[2])) << 8;
    if (length < kShortest || length > kLongest) continue;
    const size_t size = kHeadSize + length + 1;
    if (rest.size() < size) break;
    const size_t checksum_at = size - 2;
    if (rest[size - 1] != kEnd || rest[checksum_at] != Checksum(rest.substr(0, checksum_at))) {
      continue;
    }
    frame = NomadFrame{static_cast<NomadType>(rest[kHeadSize]),
                       std::string(rest.substr(kHeadSize + 1, length - kShortest))};
    rejected_bytes_ += static_cast<int64_t>(begin);
    buffer_.erase(0, begin + size);
    return frame;
  }
  rejected_bytes_ += static_cast<int64_t>(begin);
  buffer_.erase(0, begin);
  return frame;
}

}  // namespace geon::device
