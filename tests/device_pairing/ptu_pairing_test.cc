#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "base/angles.h"
#include "device/ptu_driver.h"
#include "sim/ptu_emulator.h"
#include "tests/device_pairing/paired_line.h"

namespace geon {
namespace {

using sensor::DeviceStatus;

constexpr double kCount_rad = 185.1428 / 3600.0 * kPi / 180.0;

class PtuPairingTest : public testing::Test {
 protected:
  bool Ready() const { return driver_.report().status == DeviceStatus::kReady; }
  bool BecomesReady(double limit_s) {
    return line_.RunUntil([this] { return Ready(); }, limit_s);
  }
  void LookAt(double pan_rad, double tilt_rad, double speed_rad_s = 0.0) {
    driver_.SetTarget({pan_rad, tilt_rad, speed_rad_s, ++id_});
  }
  // Both the driver's word and the truth.
  bool Arrives(double pan_rad, double tilt_rad, double limit_s) {
    return line_.RunUntil(
        [&] {
          const device::PtuReport& r = driver_.report();
          return Ready() && r.command_id == id_ && !r.moving &&
                 std::abs(r.pan_rad - pan_rad) < kCount_rad &&
                 std::abs(r.tilt_rad - tilt_rad) < kCount_rad &&
                 std::abs(unit_.pan_rad() - pan_rad) < kCount_rad &&
                 std::abs(unit_.tilt_rad() - tilt_rad) < kCount_rad;
        },
        limit_s);
  }

  sim::PtuEmulator unit_;
  device::PtuDriver driver_;
  PairedLine<device::PtuDriver> line_{&driver_, &unit_};
  int64_t id_ = 0;
};

TEST_F(PtuPairingTest, AnEchoingVerboseUnitIsReadyWithinASecondAndAHalf) {
  ASSERT_TRUE(BecomesReady(1.5)) << driver_.report().text;
  ASSERT_TRUE(line_.RunUntil([this] { return driver_.report().samples > 0; }, 0.2));
  EXPECT_NEAR(driver_.report().pan_min_rad, -3090 * kCount_rad, 1e-9);
  EXPECT_NEAR(driver_.report().pan_max_rad, 3090 * kCount_rad, 1e-9);
  EXPECT_NEAR(driver_.report().tilt_min_rad, -907 * kCount_rad, 1e-9);
  EXPECT_NEAR(driver_.report().tilt_max_rad, 604 * kCount_rad, 1e-9);
}

TEST_F(PtuPairingTest, MovesWhereItIsToldLeftAndUpPositive) {
  for (const auto& [pan_rad, tilt_rad] :
       {std::pair{0.8, 0.3}, std::pair{-1.2, -0.5}, std::pair{0.0, 0.0}}) {
    LookAt(pan_rad, tilt_rad);
    EXPECT_TRUE(Arrives(pan_rad, tilt_rad, 6.0)) << driver_.report().text;
  }
  EXPECT_EQ(driver_.report().recoveries, 0);
}

// A slow line tells where the head was some hundredths of a second ago, the pan before the tilt.
TEST_F(PtuPairingTest, SaysWhereTheHeadWasWhenItWasThere) {
  ASSERT_TRUE(BecomesReady(2.0));
  const double speed_rad_s = RadiansFromDegrees(15.0);
  LookAt(0.6, 0.45, speed_rad_s);
  std::vector<std::array<double, 3>> truth;  // time, pan, tilt
  std::vector<device::PtuReport> told;
  line_.RunUntil(
      [&] {
        truth.push_back({line_.time_s(), unit_.pan_rad(), unit_.tilt_rad()});
        const device::PtuReport& report = driver_.report();
        if (told.empty() || report.samples != told.back().samples) told.push_back(report);
        return line_.time_s() > 3.5;
      },
      3.5);
  int moving = 0;
  for (const device::PtuReport& report : told) {
    const auto then = std::find_if(truth.begin(), truth.end(), [&](const auto& state) {
      return state[0] >= report.sample_time_s;
    });
    ASSERT_NE(then, truth.end());
    if (report.samples < 3 || (*then)[1] < 0.05 || (*then)[1] > 0.4) continue;  // at full speed
    ++moving;
    EXPECT_NEAR(report.pan_rad, (*then)[1], RadiansFromDegrees(0.08));
    EXPECT_NEAR(report.tilt_rad, (*then)[2], RadiansFromDegrees(0.08));
  }
  EXPECT_GT(moving, 15);
}

TEST_F(PtuPairingTest, MovingIsSaidForAsLongAsTheHeadMoves) {
  ASSERT_TRUE(BecomesReady(2.0));
  LookAt(1.0, 0.0);
  ASSERT_TRUE(line_.RunUntil([this] { return driver_.report().command_id == id_; }, 1.0));
  bool standing_said_while_moving = false;
  line_.RunUntil(
      [&] {
        // The word may lag by one sample, never lead.
        standing_said_while_moving |= unit_.moving() && !driver_.report().moving;
        return !driver_.report().moving;
      },
      5.0);
  EXPECT_FALSE(standing_said_while_moving);
  EXPECT_NEAR(unit_.pan_rad(), 1.0, kCount_rad);
}

TEST_F(PtuPairingTest, TargetsBeyondTheLimitsEndAtThem) {
  LookAt(4.0, -2.0);
  EXPECT_TRUE(Arrives(3090 * kCount_rad, -907 * kCount_rad, 10.0)) << driver_.report().text;
  LookAt(-4.0, 2.0);
  EXPECT_TRUE(Arrives(-3090 * kCount_rad, 604 * kCount_rad, 15.0));
  EXPECT_EQ(driver_.report().limit_hits, 0);
}

TEST_F(PtuPairingTest, ASlowMoveIsSlow) {
  ASSERT_TRUE(BecomesReady(2.0));
  LookAt(0.5, 0.0, 0.25);
  const double start_s = line_.time_s();
  ASSERT_TRUE(Arrives(0.5, 0.0, 10.0));
  EXPECT_NEAR(line_.time_s() - start_s, 2.0, 0.4);
}

TEST_F(PtuPairingTest, APowerCycleInMidMoveEndsAtTheTargetAllTheSame) {
  LookAt(1.5, -0.3);
  ASSERT_TRUE(line_.RunUntil([this] { return unit_.pan_rad() > 0.5; }, 5.0));
  unit_.PowerCycle(line_.time_s());
  ASSERT_TRUE(line_.RunUntil([this] { return !Ready(); }, 1.0));
  EXPECT_TRUE(Arrives(1.5, -0.3, 60.0)) << driver_.report().text;
}

TEST_F(PtuPairingTest, AStalledHeadIsResetAndLooksThereAgain) {
  LookAt(0.5, 0.1);
  ASSERT_TRUE(Arrives(0.5, 0.1, 5.0));
  LookAt(-0.5, 0.1);
  ASSERT_TRUE(line_.RunUntil([this] { return unit_.pan_rad() < 0.2; }, 5.0));
  unit_.StallPan(200.0);
  ASSERT_TRUE(line_.RunUntil([this] { return driver_.report().limit_hits > 0; }, 2.0));
  EXPECT_TRUE(Arrives(-0.5, 0.1, 60.0)) << driver_.report().text;
}

TEST(PtuPairingResetTest, AResetThatEndsWithABareStarKeepsTheAnswersInStep) {
  for (const bool with_line_end : {true, false}) {
    sim::PtuEmulatorOptions options;
    options.reset_ends_with_newline = with_line_end;
    sim::PtuEmulator unit(options);
    device::PtuDriver driver({.reset_at_start = true});
    PairedLine<device::PtuDriver> line(&driver, &unit);
    driver.SetTarget({0.4, -0.2, 0.0, 1});
    EXPECT_TRUE(line.RunUntil(
        [&] {
          return driver.report().status == DeviceStatus::kReady &&
                 driver.report().command_id == 1 && !driver.report().moving;
        },
        60.0))
        << driver.report().text;
    EXPECT_NEAR(driver.report().pan_rad, 0.4, kCount_rad);
    EXPECT_NEAR(driver.report().tilt_rad, -0.2, kCount_rad);
    EXPECT_NEAR(unit.pan_rad(), 0.4, kCount_rad);
  }
}

TEST(PtuPairingResetTest, AUnitThatStillHuntsAtPowerUpIsWaitedFor) {
  sim::PtuEmulatorOptions options;
  options.starts_with_reset = true;
  sim::PtuEmulator unit(options);
  device::PtuDriver driver;
  PairedLine<device::PtuDriver> line(&driver, &unit);
  EXPECT_TRUE(line.RunUntil([&] { return driver.report().status == DeviceStatus::kReady; }, 90.0))
      << driver.report().text;
}

TEST_F(PtuPairingTest, APortThatIsReopenedGoesOn) {
  LookAt(0.4, 0.0);
  ASSERT_TRUE(Arrives(0.4, 0.0, 5.0));
  line_.Close();
  line_.Run(1.0);
  line_.Open();
  EXPECT_TRUE(Arrives(0.4, 0.0, 5.0));
}

TEST_F(PtuPairingTest, TenThousandGarbageStringsBothWaysLeaveBothAliveAndInStep) {
  std::mt19937 random(11);
  ASSERT_TRUE(BecomesReady(2.0));
  for (int i = 0; i < 10'000; ++i) {
    line_.Garble(&random, 12);
    line_.Run(0.02);
  }
  // Noise may spell any command: the unit may have been told to save, slave, limp or hide.
  unit_.PowerCycle(line_.time_s());
  LookAt(0.3, -0.3);
  EXPECT_TRUE(Arrives(0.3, -0.3, 120.0)) << driver_.report().text;
}

}  // namespace
}  // namespace geon
