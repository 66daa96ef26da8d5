#include "sim/nomad_frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/contracts.h"

namespace geon::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<NomadFrame> PushAll(NomadFrameReader* reader, const std::vector<uint8_t>& bytes) {
  std::vector<NomadFrame> frames;
  for (const uint8_t byte : bytes) {
    for (NomadFrame& frame : reader->Push(byte)) frames.push_back(std::move(frame));
  }
  return frames;
}

// Frames as the vendor's client sends them.
const std::vector<uint8_t> kGetState = {0x01, 0x02, 0x00, 0x07, 0x0a, 0x5c};
const std::vector<uint8_t> kVelocity = {0x01, 0x08, 0x00, 0x05, 0x64, 0x00,
                                        0x32, 0x80, 0x00, 0x00, 0x24, 0x5c};

TEST(NomadFrames, AFrameIsLengthTypePayloadSumAndEnd) {
  EXPECT_EQ(EncodeNomadFrame({7, {}}), kGetState);
  EXPECT_EQ(EncodeNomadFrame({5, {0x64, 0x00, 0x32, 0x80, 0x00, 0x00}}), kVelocity);
}

TEST(NomadFrames, SignedNumbersAreMagnitudeAndSign) {
  std::vector<uint8_t> payload;
  AppendNomadSigned(-50, &payload);
  AppendNomadSigned(300, &payload);
  AppendNomadSigned(-70000, &payload);
  EXPECT_THAT(payload, ElementsAre(0x32, 0x80, 0x2c, 0x01, 0xff, 0xff));
  EXPECT_EQ(NomadSigned(payload, 0), -50);
  EXPECT_EQ(NomadSigned(payload, 2), 300);
  EXPECT_EQ(NomadSigned(payload, 4), -32767);
  EXPECT_EQ(NomadUnsigned(payload, 4), 65535);
  EXPECT_THROW(NomadSigned(payload, 5), ContractViolation);
}

TEST(NomadFrames, FindsAFrameBehindNoise) {
  NomadFrameReader reader;
  std::vector<uint8_t> bytes = {0x00, 0xff, 0x01, 0x01, 0x33, 0x5c};
  bytes.insert(bytes.end(), kGetState.begin(), kGetState.end());
  const auto frames = PushAll(&reader, bytes);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].type, 7);
}

TEST(NomadFrames, StartAndEndBytesMayOccurInside) {
  NomadFrameReader reader;
  const auto frames = PushAll(&reader, EncodeNomadFrame({12, {0x01, 0x5c, 0x5c, 0x01}}));
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_THAT(frames[0].payload, ElementsAre(0x01, 0x5c, 0x5c, 0x01));
}

TEST(NomadFrames, AWrongChecksumIsReported) {
  NomadFrameReader reader;
  std::vector<uint8_t> bytes = kGetState;
  bytes[4] ^= 0x10;
  const auto frames = PushAll(&reader, bytes);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].type, static_cast<uint8_t>(NomadType::kNak));
}

TEST(NomadFrames, HalfAFrameIsForgottenOnReset) {
  NomadFrameReader reader;
  EXPECT_THAT(PushAll(&reader, {0x01, 0x20, 0x00, 0x05, 0x01}), IsEmpty());
  reader.Reset();
  EXPECT_EQ(PushAll(&reader, kGetState).size(), 1u);
}

}  // namespace
}  // namespace geon::sim
