#include "procs/base/drive_guard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "base/angles.h"

namespace geon::base {
namespace {

using sensor::BaseStop;
using sensor::DeviceStatus;
using sensor::Laser;

class DriveGuardTest : public testing::Test {
 protected:
  DriveGuardTest() {
    guard_.DeviceReady(true);
    for (size_t i = 0; i < bearings_.size(); ++i) {
      bearings_[i] = WrapAngle(RadiansFromDegrees(18.0 * static_cast<double>(i)));
    }
  }
  void Publish() { guard_.StatePublished(time_s_, ++state_seq_); }
  void Command(double speed_m_s, double turn_rate_rad_s = 0.0) {
    sensor::BaseCommand command;
    command.utime = MicrosecondsOf(time_s_);
    command.seq = ++command_seq_;
    command.command_id = command.seq;
    command.state_seq = state_seq_;
    command.speed_m_s = speed_m_s;
    command.turn_rate_rad_s = turn_rate_rad_s;
    guard_.CommandArrived(time_s_, command);
  }
  void Bump(std::initializer_list<size_t> pressed) {
    DriveGuard::Contacts contacts{};
    for (const size_t i : pressed) contacts[i] = true;
    guard_.BumpersRead(time_s_, contacts, bearings_);
  }
  DriveDecision Decide() const { return guard_.Decide(time_s_); }
  static int64_t MicrosecondsOf(double time_s) { return static_cast<int64_t>(time_s * 1e6); }

  DriveGuard guard_;
  DriveGuard::Bearings bearings_{};
  double time_s_ = 10.0;
  int32_t state_seq_ = 0;
  int32_t command_seq_ = 0;
};

TEST_F(DriveGuardTest, ObeysAFreshAnswerAndClampsIt) {
  Publish();
  Command(0.3, -0.4);
  EXPECT_EQ(Decide().speed_m_s, 0.3);
  EXPECT_EQ(Decide().turn_rate_rad_s, -0.4);
  EXPECT_EQ(Decide().stop, BaseStop::kNone);
  EXPECT_EQ(guard_.command_id(), 1);
  Command(9.0, -9.0);
  EXPECT_EQ(Decide().speed_m_s, 0.5);
  EXPECT_NEAR(Decide().turn_rate_rad_s, -RadiansFromDegrees(60.0), 1e-12);
}

TEST_F(DriveGuardTest, ACommandExpires) {
  Publish();
  Command(0.3);
  time_s_ += 0.149;
  EXPECT_TRUE(Decide().moves());
  time_s_ += 0.002;
  EXPECT_FALSE(Decide().moves());
  EXPECT_EQ(Decide().stop, BaseStop::kCommandExpired);
}

TEST_F(DriveGuardTest, StandingStillOnRequestIsNoStop) {
  Publish();
  Command(0.0);
  time_s_ += 1.0;
  EXPECT_EQ(Decide().stop, BaseStop::kNone);
}

TEST_F(DriveGuardTest, RefusesAnswersToOldUnknownAndForeignStates) {
  Publish();
  time_s_ += 0.31;
  Command(0.3);
  EXPECT_FALSE(Decide().moves());
  EXPECT_EQ(Decide().stop, BaseStop::kStaleCommand);
  EXPECT_EQ(guard_.command_id(), 0);
  state_seq_ = 4711;  // of our predecessor
  Command(0.3);
  EXPECT_FALSE(Decide().moves());
}

TEST_F(DriveGuardTest, APlannerThatHearsNothingSinceOurRestartNeverDrivesByChance) {
  // It keeps answering state 100 of our predecessor while our own numbers pass by.
  for (int i = 1; i <= 200; ++i) {
    guard_.StatePublished(time_s_, i);
    state_seq_ = 100;
    Command(0.3);
    EXPECT_FALSE(Decide().moves()) << i;
    time_s_ += 0.05;
  }
}

TEST_F(DriveGuardTest, RepeatedOrOvertakenCommandsAreNoNews) {
  Publish();
  sensor::BaseCommand command{.utime = 50, .seq = 7, .command_id = 7, .state_seq = 1};
  command.speed_m_s = 0.2;
  guard_.CommandArrived(time_s_, command);
  for (int i = 0; i < 10; ++i) {
    time_s_ += 0.05;
    Publish();
    command.state_seq = state_seq_;
    guard_.CommandArrived(time_s_, command);
    sensor::BaseCommand older = command;
    older.seq = 6;
    older.utime = 40;
    older.speed_m_s = 0.5;
    guard_.CommandArrived(time_s_, older);
  }
  EXPECT_FALSE(Decide().moves());
  EXPECT_EQ(guard_.command_id(), 7);
}

TEST_F(DriveGuardTest, ARestartedPlannerIsHeardAfterAPause) {
  Publish();
  command_seq_ = 1000;
  Command(0.2);
  command_seq_ = 0;
  time_s_ += 0.1;
  Publish();
  Command(0.4);
  EXPECT_EQ(Decide().speed_m_s, 0.2);
  time_s_ += 0.3;
  Publish();
  Command(0.4);
  EXPECT_EQ(Decide().speed_m_s, 0.4);
}

TEST_F(DriveGuardTest, NumbersThatAreNoneAreRefused) {
  Publish();
  Command(std::numeric_limits<double>::quiet_NaN());
  Command(0.1, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(Decide().moves());
  EXPECT_EQ(guard_.command_id(), 0);
}

TEST_F(DriveGuardTest, AHitStopsAtOnceAndTheSameCommandDoesNotHelp) {
  Publish();
  Command(0.3);
  Bump({0});
  EXPECT_FALSE(Decide().moves());
  EXPECT_EQ(Decide().stop, BaseStop::kBumper);
  Command(-0.1);  // answers a state from before the hit: its sender knows nothing of it
  EXPECT_FALSE(Decide().moves());
}

TEST_F(DriveGuardTest, BackingOffIsAllowedPushingIsNot) {
  Bump({0});
  time_s_ += 0.05;
  Publish();
  Command(0.1);
  EXPECT_EQ(Decide().stop, BaseStop::kBumper);
  Command(-0.1);
  EXPECT_EQ(Decide().speed_m_s, -0.1);
  Command(0.0, 0.5);  // the base does not turn with the steering
  EXPECT_EQ(Decide().turn_rate_rad_s, 0.5);
  Bump({0, 10});  // touched behind as well
  time_s_ += 0.05;
  Publish();
  Command(-0.1);
  EXPECT_FALSE(Decide().moves());
}

TEST_F(DriveGuardTest, AContactAtTheSideAllowsNeitherWayUntilTurned) {
  Bump({5});  // at 90 degrees
  time_s_ += 0.05;
  Publish();
  Command(0.1);
  EXPECT_FALSE(Decide().moves());
  Command(-0.1);
  EXPECT_FALSE(Decide().moves());
  for (double& bearing : bearings_) bearing = WrapAngle(bearing + RadiansFromDegrees(40.0));
  Bump({5});
  Command(0.1);
  EXPECT_EQ(Decide().speed_m_s, 0.1);
}

TEST_F(DriveGuardTest, AContactIsRememberedUntilFreeAndKnown) {
  Bump({0});
  time_s_ += 0.05;
  Bump({});  // chatter
  Publish();
  Command(0.1);
  EXPECT_EQ(Decide().stop, BaseStop::kBumper);
  time_s_ += 0.2;
  Bump({});
  Publish();
  Command(0.1);
  EXPECT_EQ(Decide().stop, BaseStop::kBumper) << "free, but nobody has moved away";
  Command(-0.1);
  EXPECT_TRUE(Decide().moves());
  Command(0.1);
  EXPECT_EQ(Decide().speed_m_s, 0.1);
  EXPECT_EQ(guard_.contact_count(), 1);
}

TEST_F(DriveGuardTest, ChatterIsOneContact) {
  for (int i = 0; i < 10; ++i) {
    if (i % 2) {
      Bump({});
    } else {
      Bump({3});
    }
    EXPECT_TRUE(guard_.contacts()[3]);
    time_s_ += 0.02;
  }
  EXPECT_EQ(guard_.contact_count(), 1);
}

TEST_F(DriveGuardTest, NoDriveWhileALaserBurnsOrMayBurn) {
  Publish();
  Command(0.3);
  guard_.LasersReported({.status = DeviceStatus::kReady, .laser = Laser::kVertical});
  EXPECT_EQ(Decide().stop, BaseStop::kLaserOn);
  guard_.LasersReported({.status = DeviceStatus::kStarting, .laser = Laser::kNone});
  EXPECT_EQ(Decide().stop, BaseStop::kLaserOn) << "a daemon that starts knows nothing yet";
  guard_.LasersReported({.status = DeviceStatus::kReady, .laser = Laser::kNone});
  EXPECT_TRUE(Decide().moves());
}

TEST_F(DriveGuardTest, ALostDeviceNeedsANewCommand) {
  Publish();
  Command(0.3);
  guard_.DeviceReady(false);
  EXPECT_EQ(Decide().stop, BaseStop::kDeviceLost);
  Command(0.3);
  EXPECT_EQ(guard_.command_id(), 1) << "not taken while lost";
  guard_.DeviceReady(true);
  EXPECT_FALSE(Decide().moves());
}

// Whatever happens, in whatever order: whenever the drive moves, every rule holds, judged by a
// second account of what happened.
TEST_F(DriveGuardTest, NoSequenceOfEventsBreaksARule) {
  std::mt19937 random(8);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::map<int32_t, double> published_s;
  std::map<int64_t, std::pair<sensor::BaseCommand, double>> arrived;  // with the time of arrival
  DriveGuard::Contacts pressed{};
  bool ready = true;
  bool burning = false;
  int moves = 0;
  for (int step = 0; step < 300'000; ++step) {
    time_s_ += uniform(0.0, 0.03);
    switch (random() % 8) {
      case 0:
      case 1:
        Publish();
        published_s[state_seq_] = time_s_;
        break;
      case 2:
      case 3:
      case 4: {
        sensor::BaseCommand command;
        command.seq = ++command_seq_ - (random() % 10 == 0 ? 3 : 0);
        command.utime = MicrosecondsOf(time_s_);
        command.command_id = step + 1;
        command.state_seq = state_seq_ - static_cast<int32_t>(random() % 6) + 1;
        command.speed_m_s = random() % 4 == 0 ? 0.0 : uniform(-1.0, 1.0);
        command.turn_rate_rad_s = uniform(-2.0, 2.0);
        arrived[command.command_id] = {command, time_s_};
        guard_.CommandArrived(time_s_, command);
        break;
      }
      case 5:
        if (random() % 20 == 0) pressed[random() % pressed.size()] = true;
        if (random() % 3 == 0) pressed = {};
        guard_.BumpersRead(time_s_, pressed, bearings_);
        break;
      case 6:
        burning = random() % 5 == 0;
        guard_.LasersReported(
            {.status = DeviceStatus::kReady, .laser = burning ? Laser::kHorizontal : Laser::kNone});
        break;
      default:
        ready = random() % 10 != 0;
        guard_.DeviceReady(ready);
    }
    const DriveDecision decision = Decide();
    if (!decision.moves()) continue;
    ++moves;
    ASSERT_TRUE(ready);
    ASSERT_FALSE(burning);
    ASSERT_LE(std::abs(decision.speed_m_s), 0.5);
    ASSERT_LE(std::abs(decision.turn_rate_rad_s), RadiansFromDegrees(60.0) + 1e-12);
    const auto& [command, arrival_s] = arrived.at(guard_.command_id());
    ASSERT_LE(time_s_ - arrival_s, 0.15);
    ASSERT_TRUE(published_s.contains(command.state_seq));
    ASSERT_LE(arrival_s - published_s[command.state_seq], 0.3);
    ASSERT_GE(decision.speed_m_s * command.speed_m_s, 0.0);
    for (size_t i = 0; i < pressed.size(); ++i) {
      if (!pressed[i] || decision.speed_m_s == 0.0) continue;
      const double towards = std::cos(bearings_[i]) * decision.speed_m_s;
      ASSERT_LT(towards, 0.0) << "pushes against bumper " << i;
    }
  }
  EXPECT_GT(moves, 30'000) << "the property must be about something";
}

}  // namespace
}  // namespace geon::base
