#include "sim/nomad_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::sim {
namespace {

using ::testing::ElementsAre;

constexpr size_t kAlways = 7;  // motors, time, volts

TEST(NomadState, AnEmptyMaskLeavesWhatIsAlwaysSent) {
  NomadState state;
  state.motors_active = 5;
  state.time_ms = 0x01020304;
  state.cpu_volts_raw = 200;
  state.motor_volts_raw = 210;
  EXPECT_THAT(EncodeNomadState(state, {}), ElementsAre(5, 0x04, 0x03, 0x02, 0x01, 200, 210));
}

TEST(NomadState, TheFullPacketIs52BytesLong) {
  const NomadMask all = {0xff, 0xff, 0xff, 0xff, 0xff, 0x01, 0x01};
  EXPECT_EQ(EncodeNomadState({}, all).size(), 52u);
}

TEST(NomadState, InfraredIsPackedTwoToAByteLowFirst) {
  NomadState state;
  state.infrared[1] = 3;
  state.infrared[2] = 9;
  state.infrared[9] = 7;
  const auto payload = EncodeNomadState(state, {0x06, 0x02, 0, 0, 0, 0, 0});
  ASSERT_EQ(payload.size(), 2 + kAlways);
  EXPECT_EQ(payload[0], 0x93);
  EXPECT_EQ(payload[1], 0x07);
}

TEST(NomadState, OnlyMaskedSonarsAreSentInOrder) {
  NomadState state;
  for (size_t i = 0; i < 16; ++i) state.sonar_in[i] = static_cast<uint8_t>(100 + i);
  const auto payload = EncodeNomadState(state, {0, 0, 0x81, 0x01, 0, 0, 0});
  ASSERT_EQ(payload.size(), 3 + kAlways);
  EXPECT_EQ(payload[0], 100);
  EXPECT_EQ(payload[1], 107);
  EXPECT_EQ(payload[2], 108);
}

TEST(NomadState, BumpersComeHighByteFirst) {
  NomadState state;
  state.bumpers = (1u << 19) | (1u << 8) | 1u;
  const auto payload = EncodeNomadState(state, {0, 0, 0, 0, 0x01, 0, 0});
  ASSERT_EQ(payload.size(), 3 + kAlways);
  EXPECT_EQ(payload[0], 0x08);
  EXPECT_EQ(payload[1], 0x01);
  EXPECT_EQ(payload[2], 0x01);
}

TEST(NomadState, ConfigurationVelocityCompassAndLaserFollow) {
  NomadState state;
  state.configuration = {100, -2, 3, 4};
  state.velocity = {5, -6, 7};
  state.compass = -8;
  const auto payload = EncodeNomadState(state, {0, 0, 0, 0, 0xfe, 0x01, 0x01});
  ASSERT_EQ(payload.size(), 18 + kAlways);
  EXPECT_EQ(payload[0], 100);
  EXPECT_EQ(payload[3], 0x80);
  EXPECT_EQ(payload[8], 5);
  EXPECT_EQ(payload[11], 0x80);
  EXPECT_EQ(payload[14], 8);  // compass before laser
  EXPECT_EQ(payload[16], 0);
}

TEST(NomadState, VoltsUseTheConvertersScale) {
  EXPECT_EQ(NomadRawVolts(12.0, 12.0), 255);
  EXPECT_EQ(NomadRawVolts(4.8, 12.0), 0);
  EXPECT_NEAR((2.0 + 3.0 * NomadRawVolts(11.4, 12.0) / 255.0) * 12.0 / 5.0, 11.4, 0.02);
}

}  // namespace
}  // namespace geon::sim
