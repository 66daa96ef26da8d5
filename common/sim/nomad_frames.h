#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace geon::sim {

// Command and reply types of the Nomad 200 (hardware card 2.3).
enum class NomadType : uint8_t {
  kAcceleration = 1,
  kSpeed = 2,
  kMoveRelative = 3,
  kMoveAbsolute = 4,
  kVelocity = 5,
  kMask = 6,
  kGetState = 7,
  kNak = 8,
  kStop = 9,
  kLimp = 10,
  kTalk = 11,
  kDefinePosition = 12,
  kZero = 13,
  kConfigureInfrared = 14,
  kConfigureSonar = 15,
  kConfigureCompass = 16,
  kConfigureLaser = 17,
  kConfigureTimeout = 18,
  kGetInfrared = 19,
  kGetSonar = 20,
  kGetConfiguration = 21,
  kGetVelocity = 22,
  kGetAcceleration = 23,
  kGetCompass = 24,
  kGetLaser = 25,
  kGetBumper = 27,
  kConfigureScan = 28,
  kGetScan = 29,
  kDefineAngles = 30,
  kWaitStop = 31,
  kMoveServos = 43,
};

struct NomadFrame {
  uint8_t type = 0;
  std::vector<uint8_t> payload;
};

// Whether the payload is as long as its command wants it. What is said aloud may be of any length.
bool WellFormed(const NomadFrame& frame);

// 0x01 | length lo hi | type | payload | checksum | 0x5C.
std::vector<uint8_t> EncodeNomadFrame(const NomadFrame& frame);

// Numbers in a payload: little-endian; signed ones as magnitude and sign bit.
int NomadSigned(std::span<const uint8_t> payload, size_t offset);
int NomadUnsigned(std::span<const uint8_t> payload, size_t offset);
void AppendNomadSigned(int value, std::vector<uint8_t>* payload);
void AppendNomadUnsigned(int value, std::vector<uint8_t>* payload);
void AppendNomadUnsigned32(uint32_t value, std::vector<uint8_t>* payload);

// The robot's ear: finds frames in a stream of bytes. What cannot be a frame is skipped byte by
// byte; a whole frame with a wrong checksum is reported as one of type NAK.
class NomadFrameReader {
 public:
  // Frames completed by this byte, in order.
  std::vector<NomadFrame> Push(uint8_t byte);
  // Forgets the beginning of a frame: the line has been quiet for too long.
  void Reset() { buffer_.clear(); }

 private:
  static constexpr size_t kLongestFrame = 256;

  std::vector<uint8_t> buffer_;
};

}  // namespace geon::sim
