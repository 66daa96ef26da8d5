#include "device/nomad_driver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "base/angles.h"
#include "base/contracts.h"
#include "tests/common/device/scripted_nomad.h"
#include "tests/common/device/virtual_line.h"

namespace geon::device {
namespace {

using sensor::DeviceStatus;

class NomadDriverTest : public testing::Test {
 protected:
  bool Ready() const { return driver_.report().status == DeviceStatus::kReady; }
  bool BecomesReady(double limit_s = 3.0) {
    return line_.RunUntil([this] { return Ready(); }, limit_s);
  }
  bool LosesReadiness(double limit_s = 1.0) {
    return line_.RunUntil([this] { return !Ready(); }, limit_s);
  }
  bool Stands(double limit_s = 1.0) {
    return line_.RunUntil([this] { return driver_.report().halted; }, limit_s);
  }
  int64_t Count(int type) const {
    return std::count(robot_.types.begin(), robot_.types.end(), type);
  }

  ScriptedNomad robot_;
  NomadDriver driver_;
  VirtualLine<NomadDriver> line_{
      &driver_, [this](double t, const std::string& heard) { return robot_.Step(t, heard); }};
};

TEST_F(NomadDriverTest, SetsUpDeadManSonarAndLimitsAfterAStop) {
  ASSERT_TRUE(BecomesReady(0.5));
  const std::vector<int> setup(robot_.types.begin(), robot_.types.begin() + 7);
  EXPECT_EQ(setup, (std::vector<int>{9, 6, 18, 15, 1, 2, 7}));
  EXPECT_EQ(robot_.timeout_s, 1);
  EXPECT_EQ(robot_.sonar_rate, 15);
  EXPECT_EQ(robot_.acceleration, 300);
}

TEST_F(NomadDriverTest, ReportsTheRobotInMetresAndRadians) {
  robot_.pose[0] = 1000;
  robot_.pose[1] = -1000;
  robot_.pose[2] = robot_.pose[3] = 2700;
  robot_.bumpers = 1u << 19 | 1u;
  ASSERT_TRUE(BecomesReady());
  const NomadSample& s = driver_.report().sample;
  EXPECT_NEAR(s.x_m, 2.54, 1e-9);
  EXPECT_NEAR(s.y_m, -2.54, 1e-9);
  EXPECT_NEAR(s.steer_rad, -kPi / 2, 1e-9);
  EXPECT_NEAR(s.sonar_m[3], 2.54, 1e-9);
  EXPECT_TRUE(s.bumper[0] && s.bumper[19]);
  EXPECT_EQ(std::count(s.bumper.begin(), s.bumper.end(), true), 2);
  EXPECT_NEAR(s.cpu_volts, 12.0, 1e-9);
  robot_.sonar_in = 255;
  line_.Run(0.2);
  EXPECT_TRUE(std::isnan(driver_.report().sample.sonar_m[3]));
}

TEST_F(NomadDriverTest, PollsTwentyTimesASecondStandingAndDriving) {
  ASSERT_TRUE(BecomesReady());
  ASSERT_TRUE(Stands());
  int before = driver_.report().samples;
  line_.Run(5.0);
  EXPECT_NEAR(driver_.report().samples - before, 100, 5);
  driver_.Drive(0.1, 0.0);
  before = driver_.report().samples;
  line_.Run(5.0);
  EXPECT_NEAR(driver_.report().samples - before, 100, 5);
}

TEST_F(NomadDriverTest, ClampsSpeedsBecauseTheFrameDoesNot) {
  ASSERT_TRUE(BecomesReady());
  driver_.Drive(2.0, -9.0);
  line_.Run(0.1);
  EXPECT_EQ(robot_.velocity[0], 196);  // 0.49784 m/s, never above 0.5
  EXPECT_EQ(robot_.velocity[1], -600);
  EXPECT_EQ(robot_.velocity[2], -600) << "the turret turns with the steering";
  EXPECT_THROW(driver_.Drive(std::numeric_limits<double>::quiet_NaN(), 0.0), ContractViolation);
}

TEST_F(NomadDriverTest, LeadsTheTurretBackToTheSteeringWhileDriving) {
  robot_.pose[2] = 100;
  robot_.pose[3] = 50;
  ASSERT_TRUE(BecomesReady());
  driver_.Drive(0.1, 0.0);
  line_.Run(0.1);
  EXPECT_EQ(robot_.velocity[1], 0);
  EXPECT_NEAR(robot_.velocity[2], 50, 1);  // 5 degrees behind: 5 degrees/s
}

TEST_F(NomadDriverTest, AStopGoesOutAtOnceAndIsConfirmed) {
  ASSERT_TRUE(BecomesReady());
  driver_.Drive(0.4, 0.0);
  line_.Run(1.0);
  EXPECT_FALSE(driver_.report().halted);
  driver_.Halt();
  const double asked_s = line_.time_s();
  ASSERT_TRUE(line_.RunUntil([&] { return robot_.velocity[0] == 0; }, 1.0));
  EXPECT_LE(line_.time_s() - asked_s, 0.02);
  EXPECT_TRUE(Stands());
}

TEST_F(NomadDriverTest, TheStopIsRepeatedWhileTheRobotStillMoves) {
  ASSERT_TRUE(BecomesReady());
  ASSERT_TRUE(Stands());
  const auto stops = Count(9);
  robot_.velocity[0] = 40;  // as if it had not obeyed
  ASSERT_TRUE(line_.RunUntil([&] { return Count(9) > stops; }, 0.2));
  EXPECT_EQ(robot_.velocity[0], 0);
}

// Fault table.

TEST_F(NomadDriverTest, OneBadReplyIsAskedForAgainWithoutAFuss) {
  ASSERT_TRUE(BecomesReady());
  const std::string good = ScriptedNomad::Frame(7, robot_.StatePayload(line_.time_s()));
  std::string bad_sum = good;
  bad_sum[10] = 1;
  for (const std::string& bad : {bad_sum, good.substr(0, 20), std::string("\x01\xff\xff garbage"),
                                 ScriptedNomad::Frame(8, ""),
                                 ScriptedNomad::Frame(27, std::string(7, '\0')), std::string()}) {
    ASSERT_TRUE(BecomesReady());
    line_.Run(0.2);
    const int recoveries = driver_.report().recoveries;
    const int samples = driver_.report().samples;
    robot_.override_next = bad;
    if (bad.empty()) line_.Inject(ScriptedNomad::Frame(7, robot_.StatePayload(line_.time_s())));
    line_.Run(1.0);
    EXPECT_TRUE(Ready());
    EXPECT_EQ(driver_.report().recoveries, recoveries);
    EXPECT_GT(driver_.report().samples, samples + 10);
  }
}

TEST_F(NomadDriverTest, GarbageBeforeAGoodFrameCostsNothing) {
  ASSERT_TRUE(BecomesReady());
  line_.Run(0.2);
  line_.Inject("\xff\x5c\x7f");
  const int before = driver_.report().samples;
  line_.Run(1.0);
  EXPECT_NEAR(driver_.report().samples - before, 20, 2);
}

TEST_F(NomadDriverTest, WhenAnswersStayAwayTheRobotIsStoppedWithinHalfASecond) {
  ASSERT_TRUE(BecomesReady());
  driver_.Drive(0.5, 0.0);
  line_.Run(1.0);
  robot_.hears_only = true;
  const double since_s = line_.time_s();
  ASSERT_TRUE(line_.RunUntil([&] { return robot_.velocity[0] == 0; }, 2.0));
  EXPECT_LE(line_.time_s() - since_s, 0.5);
  EXPECT_FALSE(Ready());
  robot_.hears_only = false;
  ASSERT_TRUE(BecomesReady());
  line_.Run(0.5);
  EXPECT_EQ(robot_.velocity[0], 0) << "nobody has asked to drive again";
}

TEST_F(NomadDriverTest, ARestartedRobotIsSetUpAgainAndTheOdometryGoesOn) {
  robot_.pose[0] = 500;
  robot_.pose[2] = robot_.pose[3] = 900;
  ASSERT_TRUE(BecomesReady());
  line_.Run(1.0);
  const NomadSample before = driver_.report().sample;
  robot_.alive = false;
  ASSERT_TRUE(LosesReadiness());
  line_.Run(3.0);
  robot_.PowerCycle(line_.time_s());
  robot_.alive = true;
  ASSERT_TRUE(BecomesReady());
  EXPECT_EQ(robot_.timeout_s, 1);
  EXPECT_EQ(driver_.report().restarts, 1);
  EXPECT_NEAR(driver_.report().sample.x_m, before.x_m, 1e-9);
  EXPECT_NEAR(driver_.report().sample.steer_rad, before.steer_rad, 1e-9);
  robot_.pose[0] = 100;  // ahead, by the robot's new reckoning: along +y of W
  line_.Run(0.2);
  EXPECT_NEAR(driver_.report().sample.x_m, before.x_m, 1e-9);
  EXPECT_NEAR(driver_.report().sample.y_m, before.y_m + 0.254, 1e-9);
}

TEST_F(NomadDriverTest, ARestartBetweenTwoPollsIsSeenByMaskOrClock) {
  ASSERT_TRUE(BecomesReady());
  line_.Run(2.0);
  robot_.PowerCycle(line_.time_s());
  ASSERT_TRUE(LosesReadiness(0.2));
  ASSERT_TRUE(BecomesReady());
  EXPECT_EQ(driver_.report().restarts, 1);
  line_.Run(2.0);
  robot_.PowerCycle(line_.time_s());
  robot_.masked = true;  // the same length by chance
  ASSERT_TRUE(LosesReadiness(0.2));
  ASSERT_TRUE(BecomesReady());
  EXPECT_EQ(robot_.timeout_s, 1);
  EXPECT_EQ(driver_.report().restarts, 2);
}

TEST_F(NomadDriverTest, ALostLineKeepsTheOdometryOfARobotThatStayedOn) {
  robot_.pose[0] = 500;
  ASSERT_TRUE(BecomesReady());
  driver_.Disconnected(line_.time_s());
  EXPECT_EQ(driver_.report().status, DeviceStatus::kUnknown);
  line_.Run(2.0);
  robot_.pose[0] = 520;  // it rolled on
  driver_.Connected(line_.time_s());
  ASSERT_TRUE(BecomesReady());
  EXPECT_NEAR(driver_.report().sample.x_m, 52 * 0.0254, 1e-9);
  EXPECT_EQ(driver_.report().restarts, 0);
}

TEST_F(NomadDriverTest, SilenceBecomesAFaultThatNamesWhatToCheck) {
  robot_.alive = false;
  ASSERT_TRUE(
      line_.RunUntil([&] { return driver_.report().status == DeviceStatus::kFault; }, 10.0));
  EXPECT_NE(driver_.report().text.find("38400"), std::string::npos);
  robot_.alive = true;
  EXPECT_TRUE(BecomesReady());
}

TEST_F(NomadDriverTest, NeverSendsAMoveThatMustNotBeRepeated) {
  ASSERT_TRUE(BecomesReady());
  driver_.Drive(0.1, 0.1);
  line_.Run(2.0);
  robot_.alive = false;
  line_.Run(2.0);
  robot_.alive = true;
  line_.Run(2.0);
  for (const int relative_move : {3, 12, 30}) EXPECT_EQ(Count(relative_move), 0);
}

TEST_F(NomadDriverTest, TenThousandRandomStringsLeaveItInStep) {
  std::mt19937 random(5);
  ASSERT_TRUE(BecomesReady());
  for (int i = 0; i < 10'000; ++i) {
    std::string noise(1 + random() % 30, '\0');
    for (char& byte : noise) byte = random() % 4 ? static_cast<char>(random()) : '\x01';
    line_.Inject(noise);
    line_.Run(0.02);
  }
  ASSERT_TRUE(line_.RunUntil([&] { return driver_.report().halted; }, 10.0));
  driver_.Drive(0.2, 0.0);
  line_.Run(0.2);
  EXPECT_EQ(robot_.velocity[0], 78);
  EXPECT_TRUE(Ready());
}

TEST(NomadDriverOptionsTest, TheDeadManMustOutliveThePolls) {
  EXPECT_THROW(NomadDriver({.poll_period_s = 0.5}), ContractViolation);
  EXPECT_THROW(NomadDriver({.dead_man_s = 0}), ContractViolation);
}

}  // namespace
}  // namespace geon::device
