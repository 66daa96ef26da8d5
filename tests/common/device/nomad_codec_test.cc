#include "device/nomad_codec.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "base/contracts.h"

namespace geon::device {
namespace {

std::string Bytes(const std::string& hex) {
  std::istringstream stream(hex);
  std::string bytes;
  for (std::string word; stream >> word;) bytes += static_cast<char>(std::stoi(word, nullptr, 16));
  return bytes;
}

std::vector<NomadFrame> Frames(NomadReader* reader, const std::string& bytes) {
  reader->Push(bytes);
  std::vector<NomadFrame> frames;
  while (const auto frame = reader->Next()) frames.push_back(*frame);
  return frames;
}

// Frames recorded from the vendor's own client.
TEST(NomadCodecTest, EncodesLikeTheVendorsClient) {
  EXPECT_EQ(EncodeNomadFrame(NomadType::kState), Bytes("01 02 00 07 0a 5c"));
  EXPECT_EQ(EncodeNomadFrame(NomadType::kMask, Bytes("ff ff ff ff ff 01 01")),
            Bytes("01 09 00 06 ff ff ff ff ff 01 01 0d 5c"));
  EXPECT_EQ(EncodeSpeed(200, 450, 450), Bytes("01 08 00 02 c8 00 c2 01 c2 01 59 5c"));
  EXPECT_EQ(EncodeAcceleration(300, 300, 300), Bytes("01 08 00 01 2c 01 2c 01 2c 01 91 5c"));
  EXPECT_EQ(EncodeVelocity(100, -50, 0), Bytes("01 08 00 05 64 00 32 80 00 00 24 5c"));
  EXPECT_EQ(EncodeTimeout(5), Bytes("01 03 00 12 05 1b 5c"));
  EXPECT_EQ(EncodeSonarOrder(15, {0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8}),
            Bytes("01 13 00 0f 0f 00 02 0f 01 0e 03 0d 04 0c 05 0b 06 0a 07 09 08 aa 5c"));
  EXPECT_EQ(EncodeNomadFrame(NomadType::kStop), Bytes("01 02 00 09 0c 5c"));
}

TEST(NomadCodecTest, MaskSelectsGroups) {
  NomadMask mask;
  EXPECT_EQ(EncodeMask(mask).substr(4, 7), Bytes("ff ff ff ff ff 00 00"));
  mask.infrared = 0x8001;
  mask.sonar = 0x0100;
  mask.bumper = false;
  mask.velocity = false;
  mask.compass = true;
  EXPECT_EQ(EncodeMask(mask).substr(4, 7), Bytes("01 80 00 01 1e 00 01"));
  EXPECT_EQ(NomadStateLength(mask), 1u + 1u + 8u + 2u + 7u);
}

TEST(NomadCodecTest, SignMagnitudeGoesThereAndBack) {
  EXPECT_EQ(EncodeSignMagnitude(-50), Bytes("32 80"));
  for (int value = -kNomadMaxMagnitude; value <= kNomadMaxMagnitude; ++value) {
    const std::string bytes = EncodeSignMagnitude(value);
    ASSERT_EQ(DecodeSignMagnitude(static_cast<uint8_t>(bytes[0]), static_cast<uint8_t>(bytes[1])),
              value);
  }
  EXPECT_EQ(DecodeSignMagnitude(0x00, 0x80), 0);  // there is a negative zero
  EXPECT_THROW(EncodeSignMagnitude(-32768), ContractViolation);
}

TEST(NomadCodecTest, StateFieldsComeInTheirOrder) {
  const std::string payload = Bytes(
      "10 32 54 76 98 ba dc fe "                          // infrared 0..15, low nibble first
      "11 12 13 14 15 16 17 18 19 1a 1b 1c 1d 1e 1f ff "  // sonar
      "08 00 01 "                                         // bumpers 0 and 19
      "0a 00 14 80 84 03 08 07 "                          // 10, -20, 900, 1800
      "c8 00 32 80 00 00 "                                // 200, -50, 0
      "05 10 27 00 00 ff 80");
  const auto state = DecodeNomadState(payload, NomadMask{});
  ASSERT_TRUE(state.has_value());
  for (int i = 0; i < 16; ++i) EXPECT_EQ(state->infrared[static_cast<size_t>(i)], i);
  EXPECT_EQ(state->sonar_in[0], 17);
  EXPECT_EQ(state->sonar_in[15], 255);
  EXPECT_EQ(state->bumpers, 0x80001u);
  EXPECT_EQ(state->configuration->x, 10);
  EXPECT_EQ(state->configuration->y, -20);
  EXPECT_EQ(state->configuration->steer, 900);
  EXPECT_EQ(state->configuration->turret, 1800);
  EXPECT_EQ(state->velocity->translation, 200);
  EXPECT_EQ(state->velocity->steer, -50);
  EXPECT_EQ(state->motors, 5);
  EXPECT_EQ(state->time_ms, 10000u);
  EXPECT_EQ(state->cpu_volts_raw, 255);
  EXPECT_EQ(state->motor_volts_raw, 128);
}

TEST(NomadCodecTest, AStateOfAnotherLengthIsNoState) {
  const std::string payload(NomadStateLength(NomadMask{}), '\0');
  EXPECT_TRUE(DecodeNomadState(payload, NomadMask{}).has_value());
  EXPECT_FALSE(DecodeNomadState(payload + '\0', NomadMask{}).has_value());
  EXPECT_FALSE(DecodeNomadState(payload.substr(1), NomadMask{}).has_value());
}

TEST(NomadCodecTest, FindsFramesThatHoldStartAndEndBytes) {
  NomadReader reader;
  const std::string frame =
      EncodeNomadFrame(NomadType::kState, Bytes("01 5c 01 02 00 07 0a 5c 5c"));
  const auto frames = Frames(&reader, frame + frame);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[1].payload, Bytes("01 5c 01 02 00 07 0a 5c 5c"));
  EXPECT_EQ(reader.rejected_bytes(), 0);
}

TEST(NomadCodecTest, AGoodFrameSurvivesGarbageBeforeItAndADamagedOneIsDropped) {
  NomadReader reader;
  const std::string good = EncodeNomadFrame(NomadType::kState, "abc");
  auto frames = Frames(&reader, Bytes("ff 5c 01 00 00 5c") + good);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].payload, "abc");
  for (size_t i = 0; i < good.size(); ++i) {
    std::string damaged = good;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    NomadReader fresh;
    // A damaged length makes the reader wait for more; what follows completes it and is found.
    frames = Frames(&fresh, damaged + good + std::string(320, '\0'));
    ASSERT_EQ(frames.size(), 1u) << i;
    EXPECT_EQ(frames[0].payload, "abc") << i;
  }
}

TEST(NomadCodecTest, FramesComeByteByByte) {
  NomadReader reader;
  const std::string frame = EncodeVelocity(1, 2, 3);
  for (size_t i = 0; i + 1 < frame.size(); ++i) {
    ASSERT_TRUE(Frames(&reader, frame.substr(i, 1)).empty());
  }
  EXPECT_EQ(Frames(&reader, frame.substr(frame.size() - 1)).size(), 1u);
}

TEST(NomadCodecTest, AnyBytesAreFollowedByStep) {
  std::mt19937 random(3);
  for (int i = 0; i < 10'000; ++i) {
    NomadReader reader;
    std::string noise(random() % 100, '\0');
    for (char& byte : noise) byte = random() % 3 == 0 ? '\x01' : static_cast<char>(random() % 8);
    Frames(&reader, noise + std::string(310, '\0'));
    ASSERT_EQ(Frames(&reader, EncodeNomadFrame(NomadType::kState)).size(), 1u);
  }
}

}  // namespace
}  // namespace geon::device
