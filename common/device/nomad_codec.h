#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "sensor/base.h"

namespace geon::device {

// Source: Nomadic Technologies' direct serial protocol of the Nomad 200. A frame is
//   0x01 | length, 2 bytes LE | type | payload | checksum | 0x5C
// length counts type, payload and checksum; the checksum is the sum of everything before it, mod
// 256. Signed 16-bit numbers are little-endian sign-magnitude. One reply to each command, of the
// same type (or NAK); nothing comes unasked. Translation in 0.1 inch (per s, s^2), rotation in 0.1
// degree.
enum class NomadType : uint8_t {
  kAcceleration = 1,  // AC
  kSpeed = 2,         // SP
  kVelocity = 5,      // VM
  kMask = 6,          // CT
  kState = 7,         // GS
  kRefused = 8,       // NAK
  kStop = 9,          // ST
  kSonarOrder = 15,   // CONF_SN
  kTimeout = 18,      // CONF_TM
};

inline constexpr double kMetresPerInch = 0.0254;
inline constexpr int kNomadMaxMagnitude = 32767;

struct NomadFrame {
  NomadType type = NomadType::kState;
  std::string payload;
};

std::string EncodeNomadFrame(NomadType type, std::string_view payload = {});
// Throws for magnitudes above kNomadMaxMagnitude.
std::string EncodeSignMagnitude(int value);
int DecodeSignMagnitude(uint8_t low, uint8_t high);

// Which fields a state packet carries (CT). Laser and position attachments are never asked for: the
// vendor's own code disagrees with itself about them.
struct NomadMask {
  uint16_t infrared = 0xffff;  // bit i: sensor i
  uint16_t sonar = 0xffff;
  bool bumper = true;
  bool configuration = true;  // x, y, steer, turret
  bool velocity = true;       // translation, steer, turret
  bool compass = false;
};

// Velocities in 0.1 inch/s and 0.1 degree/s.
std::string EncodeVelocity(int translation, int steering, int turret);
// AC and SP; unsigned, in 0.1 inch and 0.1 degree.
std::string EncodeAcceleration(int translation, int steering, int turret);
std::string EncodeSpeed(int translation, int steering, int turret);
std::string EncodeMask(const NomadMask& mask);
std::string EncodeTimeout(int timeout_s);
// `rate` in units of 4 ms between two sonars.
std::string EncodeSonarOrder(int rate, const std::array<int, sensor::kSonarCount>& order);

// Tenths of inches and degrees.
struct NomadConfiguration {
  int x = 0, y = 0, steer = 0, turret = 0;
};
struct NomadVelocity {
  int translation = 0, steer = 0, turret = 0;
};

// The fields of a state packet in the robot's own units; nothing where the mask asked for nothing.
struct NomadState {
  std::array<std::optional<int>, sensor::kInfraredCount> infrared;  // 0..15
  std::array<std::optional<int>, sensor::kSonarCount> sonar_in;     // inches; 255: no echo
  std::optional<uint32_t> bumpers;                                  // bit i: bumper i
  std::optional<NomadConfiguration> configuration;
  std::optional<NomadVelocity> velocity;
  std::optional<int> compass;
  int motors = 0;        // bit 0 translation, 1 steering, 2 turret active
  uint32_t time_ms = 0;  // since the robot's start
  int cpu_volts_raw = 0;
  int motor_volts_raw = 0;
};

// Length of the payload of a state packet under `mask`.
size_t NomadStateLength(const NomadMask& mask);
// Nothing when the payload's length is not what the mask makes it: the robot forgot the mask.
std::optional<NomadState> DecodeNomadState(std::string_view payload, const NomadMask& mask);

// Finds frames in bytes: resynchronises on the start byte after any damage (length sane, checksum
// and end byte right; start and end bytes may also occur inside a payload).
class NomadReader {
 public:
  void Push(std::string_view bytes) { buffer_ += bytes; }
  std::optional<NomadFrame> Next();
  void Clear() { buffer_.clear(); }
  int64_t rejected_bytes() const { return rejected_bytes_; }  // since start

 private:
  std::string buffer_;
  int64_t rejected_bytes_ = 0;
};

}  // namespace geon::device
