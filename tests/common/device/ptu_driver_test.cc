#include "device/ptu_driver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "base/angles.h"
#include "tests/common/device/scripted_ptu.h"
#include "tests/common/device/virtual_line.h"

namespace geon::device {
namespace {

using sensor::DeviceStatus;

constexpr double kResolution_rad = 185.1428 / 3600.0 * kPi / 180.0;

class PtuDriverTest : public testing::Test {
 protected:
  bool Ready() const { return driver_.report().status == DeviceStatus::kReady; }
  bool BecomesReady(double limit_s = 5.0) {
    return line_.RunUntil([this] { return Ready(); }, limit_s);
  }
  bool LosesReadiness(double limit_s = 2.0) {
    return line_.RunUntil([this] { return !Ready(); }, limit_s);
  }
  // Looks somewhere; true when the unit stands there and says so.
  bool Reaches(double pan_rad, double tilt_rad, int64_t id, double limit_s = 5.0) {
    driver_.SetTarget({pan_rad, tilt_rad, 0.0, id});
    return line_.RunUntil(
        [&] {
          const PtuReport& r = driver_.report();
          return Ready() && r.command_id == id && !r.moving &&
                 std::abs(r.pan_rad - pan_rad) < kResolution_rad &&
                 std::abs(r.tilt_rad - tilt_rad) < kResolution_rad;
        },
        limit_s);
  }

  ScriptedPtu unit_;
  PtuDriver driver_;
  VirtualLine<PtuDriver> line_{
      &driver_, [this](double t, const std::string& heard) { return unit_.Step(t, heard); }};
};

TEST_F(PtuDriverTest, InitialisesAVerboseEchoingUnitAndReadsItsLimits) {
  EXPECT_EQ(driver_.report().status, DeviceStatus::kStarting);
  ASSERT_TRUE(BecomesReady(1.5));
  EXPECT_FALSE(unit_.echo);
  EXPECT_FALSE(unit_.verbose);
  EXPECT_EQ(unit_.resets, 0);
  line_.Run(0.1);
  const PtuReport& r = driver_.report();
  EXPECT_NEAR(DegreesFromRadians(r.pan_max_rad), 158.92, 0.01);
  EXPECT_NEAR(DegreesFromRadians(r.tilt_min_rad), -46.65, 0.01);
  EXPECT_NEAR(DegreesFromRadians(r.tilt_max_rad), 31.06, 0.01);
  EXPECT_NE(r.version.find("v2.12.1d1"), std::string::npos);
}

TEST_F(PtuDriverTest, NeverUsesTheBlockingAwait) {
  ASSERT_TRUE(BecomesReady());
  EXPECT_TRUE(Reaches(0.5, -0.2, 1));
  line_.Run(1.0);
  EXPECT_EQ((" " + line_.TakeTraffic()).find(" A "), std::string::npos);
  EXPECT_EQ(unit_.bad_commands, 0);
}

TEST_F(PtuDriverTest, SamplesTwentyTimesASecond) {
  ASSERT_TRUE(BecomesReady());
  const int before = driver_.report().samples;
  line_.Run(5.0);
  EXPECT_NEAR(driver_.report().samples - before, 100, 5);
}

TEST_F(PtuDriverTest, ClampsTargetsAndSpeedsToWhatTheUnitSaysItCan) {
  ASSERT_TRUE(BecomesReady());
  driver_.SetTarget({10.0, -10.0, 100.0, 7});
  ASSERT_TRUE(line_.RunUntil([&] { return driver_.report().command_id == 7; }, 1.0));
  EXPECT_EQ(unit_.values["PP"], 3090);
  EXPECT_EQ(unit_.values["TP"], -907);
  EXPECT_EQ(unit_.values["PS"], 2902);
  EXPECT_NEAR(driver_.report().pan_target_rad, 3090 * kResolution_rad, 1e-9);
  driver_.SetTarget({0.0, 0.0, 1e-6, 8});
  ASSERT_TRUE(line_.RunUntil([&] { return driver_.report().command_id == 8; }, 1.0));
  EXPECT_EQ(unit_.values["PS"], 31);
  EXPECT_EQ(unit_.bad_commands, 0);
}

TEST_F(PtuDriverTest, ATargetGivenEarlyIsReachedOnceReady) {
  EXPECT_TRUE(Reaches(0.3, 0.1, 3));
  EXPECT_EQ(unit_.values["PP"], static_cast<int>(std::lround(0.3 / kResolution_rad)));
}

TEST_F(PtuDriverTest, RepeatingATargetSaysNothingNewToTheUnit) {
  ASSERT_TRUE(Reaches(0.3, 0.1, 3));
  line_.TakeTraffic();
  for (int i = 0; i < 20; ++i) {
    driver_.SetTarget({0.3, 0.1, 0.0, 3});
    line_.Run(0.1);
  }
  const std::string traffic = line_.TakeTraffic();
  EXPECT_EQ(traffic.find("PS"), std::string::npos);
  EXPECT_EQ(traffic.find_first_of("0123456789"), std::string::npos) << traffic;
}

// Fault table of the manual and of drivers in the field.

TEST_F(PtuDriverTest, ALimitMarkGluedToAnAnswerMeansResetNotANumber) {
  ASSERT_TRUE(Reaches(0.3, 0.1, 3));
  unit_.before_next_reply = "!P";
  ASSERT_TRUE(LosesReadiness());
  EXPECT_EQ(driver_.report().limit_hits, 1);
  ASSERT_TRUE(BecomesReady(10.0));
  EXPECT_EQ(unit_.resets, 1);
  EXPECT_EQ(driver_.report().limit_hits, 1) << "marks of the reset itself do not count";
  EXPECT_TRUE(Reaches(0.3, 0.1, 3)) << "the target is said again";
}

TEST_F(PtuDriverTest, AResetThatEndsWithoutLineEndDoesNotShiftTheAnswers) {
  unit_.reset_ends_with_line_end = false;
  ASSERT_TRUE(BecomesReady());
  line_.Inject("!T");
  ASSERT_TRUE(LosesReadiness());
  ASSERT_TRUE(BecomesReady(10.0));
  line_.Inject("\r\n");  // it comes late
  ASSERT_TRUE(Reaches(0.5, -0.3, 4));
  EXPECT_NEAR(driver_.report().pan_rad, 0.5, kResolution_rad);
  EXPECT_NEAR(driver_.report().tilt_rad, -0.3, kResolution_rad);
}

TEST_F(PtuDriverTest, APowerCycleIsNoticedAndTheTargetSaidAgain) {
  ASSERT_TRUE(Reaches(0.4, -0.4, 5));
  unit_.PowerCycle(line_.time_s());
  ASSERT_TRUE(LosesReadiness());
  ASSERT_TRUE(BecomesReady(10.0));
  EXPECT_FALSE(unit_.echo);
  EXPECT_FALSE(unit_.verbose);
  EXPECT_TRUE(Reaches(0.4, -0.4, 5));
  EXPECT_GE(driver_.report().recoveries, 1);
}

TEST_F(PtuDriverTest, AnUnnoticedRestartShowsByItsEchoOrItsSentences) {
  ASSERT_TRUE(BecomesReady());
  unit_.echo = true;
  ASSERT_TRUE(LosesReadiness(0.2));
  ASSERT_TRUE(BecomesReady());
  unit_.verbose = true;
  ASSERT_TRUE(LosesReadiness(0.2));
  ASSERT_TRUE(BecomesReady());
  EXPECT_FALSE(unit_.verbose);
}

TEST_F(PtuDriverTest, NoiseAndHalfLinesNeverBecomeAPosition) {
  for (const std::string bad : {"* \xff 12", "* 12x", "*", "* 99999", "* 3091",
                                "! Illegal argument", "PP * 1", "*\xff 12"}) {
    ASSERT_TRUE(BecomesReady()) << bad;
    line_.Run(0.1);
    const double pan_rad = driver_.report().pan_rad;
    unit_.override_["PP"] = bad;
    ASSERT_TRUE(LosesReadiness()) << bad;
    EXPECT_EQ(driver_.report().pan_rad, pan_rad) << bad;
    unit_.override_.clear();
  }
  EXPECT_TRUE(BecomesReady());
}

TEST_F(PtuDriverTest, AnAnswerTooManyDoesNotShiftTheOthers) {
  ASSERT_TRUE(Reaches(0.5, -0.3, 4));
  line_.Inject("* 77\r\n* 78\r\n");
  ASSERT_TRUE(LosesReadiness());
  ASSERT_TRUE(BecomesReady());
  line_.Run(0.5);
  EXPECT_NEAR(driver_.report().pan_rad, 0.5, kResolution_rad);
  EXPECT_NEAR(driver_.report().tilt_rad, -0.3, kResolution_rad);
}

TEST_F(PtuDriverTest, SilenceIsAFaultThatNamesWhatToCheckAndHeals) {
  ASSERT_TRUE(BecomesReady());
  unit_.alive = false;
  ASSERT_TRUE(LosesReadiness(1.0));
  ASSERT_TRUE(
      line_.RunUntil([&] { return driver_.report().status == DeviceStatus::kFault; }, 10.0));
  EXPECT_NE(driver_.report().text.find("9600"), std::string::npos);
  unit_.alive = true;
  EXPECT_TRUE(BecomesReady());
}

TEST_F(PtuDriverTest, AHeadThatStandsShortOfItsTargetIsToldAgainAndThenReset) {
  ASSERT_TRUE(BecomesReady());
  unit_.moves = false;
  driver_.SetTarget({0.5, 0.0, 0.0, 9});
  ASSERT_TRUE(line_.RunUntil([&] { return unit_.resets > 0; }, 10.0));
  unit_.moves = true;
  EXPECT_TRUE(Reaches(0.5, 0.0, 9, 15.0));
}

TEST_F(PtuDriverTest, AReopenedLineIsInitialisedFromTheStart) {
  ASSERT_TRUE(Reaches(0.5, 0.0, 9));
  driver_.Disconnected(line_.time_s());
  EXPECT_EQ(driver_.report().status, DeviceStatus::kUnknown);
  line_.TakeTraffic();
  line_.Run(1.0);
  EXPECT_EQ(line_.TakeTraffic(), "") << "nothing is said to a closed line";
  unit_.echo = unit_.verbose = true;
  unit_.values["PP"] = 0;
  driver_.Connected(line_.time_s());
  EXPECT_TRUE(Reaches(0.5, 0.0, 9));
}

TEST_F(PtuDriverTest, ARefusedControlModeIsNoObstacle) {
  unit_.override_["CI"] = "! Illegal Command Entered";
  EXPECT_TRUE(BecomesReady());
}

TEST(PtuDriverStartTest, ResetsAtStartWhenConfigured) {
  ScriptedPtu unit;
  PtuDriver driver({.reset_at_start = true});
  VirtualLine<PtuDriver> line(
      &driver, [&](double t, const std::string& heard) { return unit.Step(t, heard); });
  ASSERT_TRUE(line.RunUntil([&] { return driver.report().status == DeviceStatus::kReady; }, 10.0));
  EXPECT_EQ(unit.resets, 1);
}

TEST_F(PtuDriverTest, TenThousandRandomStringsLeaveItInStep) {
  std::mt19937 random(4);
  ASSERT_TRUE(BecomesReady());
  const std::string alphabet = "*!PT 0123456789-\r\nAB\xff\x01";
  for (int i = 0; i < 10'000; ++i) {
    std::string noise(1 + random() % 20, '\0');
    for (char& byte : noise) {
      byte = random() % 2 ? alphabet[random() % alphabet.size()] : static_cast<char>(random());
    }
    line_.Inject(noise);
    line_.Run(0.02);
  }
  EXPECT_TRUE(Reaches(0.25, -0.25, 11, 60.0));
  EXPECT_EQ(unit_.values["PP"], static_cast<int>(std::lround(0.25 / kResolution_rad)));
}

}  // namespace
}  // namespace geon::device
