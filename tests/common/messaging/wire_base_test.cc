// Conversions of the base's messages, health and session (messaging/wire.h).
#include <gtest/gtest.h>

#include <limits>

#include "messaging/codec.h"
#include "messaging/wire.h"
#include "tests/common/messaging/sample_messages.h"

namespace geon::messaging {
namespace {

TEST(WireBase, StateAndCommandSurviveTheRoundTrip) {
  const auto state = Decode<sensor::BaseState>(Encode(samples::BaseState()));
  ASSERT_TRUE(state.ok()) << state.message();
  EXPECT_EQ(state->x_m, 1.0);
  EXPECT_EQ(state->turn_rate_rad_s, -0.1);
  EXPECT_TRUE(state->moving);
  EXPECT_EQ(state->stop, sensor::BaseStop::kBumper);
  EXPECT_EQ(state->command_id, 43);
  const auto command =
      Decode<sensor::BaseCommand>(Encode(sensor::BaseCommand{1, 2, 3, 4, 0.2, -0.3}));
  ASSERT_TRUE(command.ok()) << command.message();
  EXPECT_EQ(command->state_seq, 4);
  EXPECT_EQ(command->speed_m_s, 0.2);
  EXPECT_EQ(command->turn_rate_rad_s, -0.3);
}

TEST(WireBase, ASpeedThatIsNoNumberIsRefused) {
  geon::base_command_t command = ToWire(sensor::BaseCommand{});
  command.speed_m_s = std::numeric_limits<double>::infinity();
  EXPECT_EQ(FromWire(command).message(), "speed_m_s is not a finite number");
}

TEST(WireBase, RangesKeepTheirMissingEchoes) {
  const auto scan = Decode<sensor::SonarScan>(Encode(samples::SonarScan()));
  ASSERT_TRUE(scan.ok()) << scan.message();
  EXPECT_TRUE(std::isnan(scan->range_m[3]));
  EXPECT_EQ(scan->range_m[4], 2.5);
  EXPECT_EQ(scan->heading_rad, 0.3);
  geon::sonar_t negative = ToWire(samples::SonarScan());
  negative.range_m[0] = -0.1;
  EXPECT_FALSE(FromWire(negative).ok());
}

TEST(WireBase, BumpersAndInfraredSurviveTheRoundTrip) {
  const auto bumper = Decode<sensor::BumperState>(Encode(samples::BumperState()));
  ASSERT_TRUE(bumper.ok()) << bumper.message();
  EXPECT_TRUE(bumper->pressed[4]);
  EXPECT_FALSE(bumper->pressed[5]);
  EXPECT_EQ(bumper->bearing_rad[19], 0.25);
  EXPECT_EQ(bumper->contact_count, 1);
  const auto infrared = Decode<sensor::InfraredScan>(Encode(samples::InfraredScan()));
  ASSERT_TRUE(infrared.ok()) << infrared.message();
  EXPECT_EQ(infrared->level[15], 15);
  geon::infrared_t bad = ToWire(samples::InfraredScan());
  bad.level[2] = 16;
  EXPECT_FALSE(FromWire(bad).ok());
}

TEST(WireBase, HealthAndSessionSurviveTheRoundTrip) {
  const auto health = Decode<sensor::Health>(Encode(samples::Health()));
  ASSERT_TRUE(health.ok()) << health.message();
  EXPECT_EQ(health->process, "geon-ptu");
  EXPECT_EQ(health->level, sensor::HealthLevel::kWarn);
  EXPECT_EQ(health->text, "slow");
  EXPECT_EQ(health->rss_bytes, 1'000'000);
  EXPECT_EQ(health->reconnects, 3);
  const auto session = Decode<sensor::Session>(Encode(samples::Session()));
  ASSERT_TRUE(session.ok()) << session.message();
  EXPECT_EQ(session->calibration_file, "lut.yaml");
  EXPECT_EQ(session->types_hash, -5);
  geon::health_t bad = ToWire(samples::Health());
  bad.level = 4;
  EXPECT_FALSE(FromWire(bad).ok());
}

}  // namespace
}  // namespace geon::messaging
