#include <gtest/gtest.h>

#include <random>

#include "device/laser_driver.h"
#include "sim/horus_emulator.h"
#include "tests/device_pairing/paired_line.h"

namespace geon {
namespace {

using sensor::DeviceStatus;
using sensor::Laser;

class LaserPairingTest : public testing::Test {
 protected:
  bool Confirms(Laser laser, double limit_s = 8.0) {
    driver_.Request(laser);
    return line_.RunUntil(
        [&] { return driver_.report().confirmed && driver_.report().laser == laser; }, limit_s);
  }
  bool Burns(Laser laser) const {
    const auto& lasers = board_.lasers();
    return lasers[0] == (laser == Laser::kHorizontal) && lasers[1] == (laser == Laser::kVertical);
  }

  sim::HorusEmulator board_;
  device::LaserDriver driver_;
  PairedLine<device::LaserDriver> line_{&driver_, &board_};
};

TEST_F(LaserPairingTest, SwitchesEachLaserAndNothingElse) {
  ASSERT_TRUE(Confirms(Laser::kNone)) << driver_.report().text;
  for (const Laser laser : {Laser::kHorizontal, Laser::kVertical, Laser::kNone, Laser::kVertical,
                            Laser::kHorizontal, Laser::kNone}) {
    const double asked_s = line_.time_s();
    ASSERT_TRUE(Confirms(laser, 0.5));
    EXPECT_TRUE(Burns(laser));
    EXPECT_FALSE(board_.lasers()[2] || board_.lasers()[3]);
    EXPECT_LT(line_.time_s() - asked_s, 0.1);
  }
  EXPECT_EQ(driver_.report().errors, 0);
}

TEST_F(LaserPairingTest, ALitLaserOutlivesTheBoardsTimeOutWhileItIsWanted) {
  ASSERT_TRUE(Confirms(Laser::kVertical));
  line_.Run(300.0);
  EXPECT_TRUE(Burns(Laser::kVertical));
  line_.Close();  // the host dies
  line_.Run(300.0);
  EXPECT_TRUE(Burns(Laser::kNone));
}

TEST_F(LaserPairingTest, ABoardThatRestartsIsDarkUntilToldAgain) {
  ASSERT_TRUE(Confirms(Laser::kHorizontal));
  board_.PowerCycle(line_.time_s());
  ASSERT_TRUE(line_.RunUntil([this] { return !driver_.report().confirmed; }, 5.0));
  ASSERT_TRUE(Confirms(Laser::kHorizontal));
  EXPECT_TRUE(Burns(Laser::kHorizontal));
}

TEST_F(LaserPairingTest, AReopenedPortStartsDark) {
  ASSERT_TRUE(Confirms(Laser::kHorizontal));
  line_.Close();
  line_.Run(0.5);
  line_.Open();
  ASSERT_TRUE(line_.RunUntil([this] { return driver_.report().confirmed; }, 8.0));
  EXPECT_TRUE(Burns(Laser::kNone));
}

TEST_F(LaserPairingTest, TenThousandGarbageStringsBothWaysLeaveBothAliveAndInStep) {
  std::mt19937 random(13);
  ASSERT_TRUE(Confirms(Laser::kNone));
  for (int i = 0; i < 10'000; ++i) {
    line_.Garble(&random, 12);
    line_.Run(0.02);
  }
  ASSERT_TRUE(Confirms(Laser::kVertical, 30.0)) << driver_.report().text;
  EXPECT_TRUE(Burns(Laser::kVertical));
  ASSERT_TRUE(Confirms(Laser::kNone));
  EXPECT_TRUE(Burns(Laser::kNone));
}

}  // namespace
}  // namespace geon
