#include "sim/horus_emulator.h"

#include <gtest/gtest.h>

#include "sim/noise_source.h"
#include "tests/common/sim/device_testing.h"

namespace geon::sim {
namespace {

constexpr char kBanner[] = "\r\nHorus 0.2 ['$' for help]\r\n";
using Lasers = std::array<bool, HorusEmulator::kLaserCount>;
constexpr Lasers kDark = {};

class HorusEmulatorTest : public ::testing::Test {
 protected:
  HorusEmulatorTest() { banner_ = host_.ListenText(1.0); }

  HorusEmulator board_;
  TestHost host_{&board_};
  std::string banner_;
};

TEST_F(HorusEmulatorTest, StartsDarkAndIntroducesItself) {
  EXPECT_EQ(banner_, kBanner);
  EXPECT_EQ(board_.lasers(), kDark);
}

TEST_F(HorusEmulatorTest, SwitchesEachLaser) {
  EXPECT_EQ(host_.Ask("M71T1\r\n"), "ok\r\n");
  EXPECT_EQ(board_.lasers(), (Lasers{true, false, false, false}));
  EXPECT_EQ(host_.Ask("m71 t2\n"), "ok\r\n");
  EXPECT_EQ(board_.lasers(), (Lasers{true, true, false, false}));
  EXPECT_EQ(host_.Ask("M70T1\rM71T4\r"), "ok\r\nok\r\n");
  EXPECT_EQ(board_.lasers(), (Lasers{false, true, false, true}));
}

TEST_F(HorusEmulatorTest, SaysOkToALaserThatDoesNotExist) {
  EXPECT_EQ(host_.Ask("M71T9\n"), "ok\r\n");
  EXPECT_EQ(host_.Ask("M71T0\n"), "ok\r\n");
  EXPECT_EQ(board_.lasers(), kDark);
}

TEST_F(HorusEmulatorTest, ABlankLineIsNotAnswered) {
  EXPECT_EQ(host_.Ask("\r\n\n  \r\n(comment only)\n"), "");
}

TEST_F(HorusEmulatorTest, ALineTooLongIsAnsweredTwice) {
  EXPECT_EQ(host_.Ask(std::string(90, 'M') + "\n"),
            "error: Line overflow\r\nerror: Bad number format\r\n");
  EXPECT_EQ(host_.Ask("M17\n"), "ok\r\n");
}

TEST_F(HorusEmulatorTest, ErrorsAreSpelledOut) {
  EXPECT_EQ(host_.Ask("M71T\n"), "error: Bad number format\r\n");
  EXPECT_EQ(host_.Ask("M99\n"), "error: Unsupported command\r\n");
  EXPECT_EQ(host_.Ask("G1X10\n"), "error: Undefined feed rate\r\n");
  EXPECT_EQ(host_.Ask("$5=1\n"), "error: Invalid statement\r\n");
  EXPECT_EQ(host_.Ask("$120=-4\n"), "error: Value < 0\r\n");
  EXPECT_EQ(host_.Ask("$120=x\n"), "error: Bad number format\r\n");
}

TEST_F(HorusEmulatorTest, CtrlXResetsAndGoesDark) {
  host_.Ask("M71T1\n");
  EXPECT_EQ(host_.Ask("\x18\r\n"), kBanner);
  EXPECT_EQ(board_.lasers(), kDark);
}

TEST_F(HorusEmulatorTest, OpeningThePortRebootsIt) {
  host_.Ask("M71T2\n");
  board_.PortOpened(host_.now_s());
  EXPECT_EQ(board_.lasers(), kDark);
  EXPECT_EQ(host_.Ask("M71T1\n", 1.0), kBanner) << "what comes while it boots is lost";
  EXPECT_EQ(board_.lasers(), kDark);
}

TEST_F(HorusEmulatorTest, LasersGoOffAfter255SecondsOfSilence) {
  host_.Ask("M71T1\n");
  host_.Listen(200.0);
  host_.Ask("\n");  // any message will do
  host_.Listen(250.0);
  EXPECT_EQ(board_.lasers(), (Lasers{true, false, false, false}));
  host_.Listen(10.0);
  EXPECT_EQ(board_.lasers(), kDark);
}

TEST_F(HorusEmulatorTest, ALaserWaitsForTheTurntable) {
  EXPECT_EQ(host_.Ask("G1F100\n"), "ok\r\n");
  EXPECT_EQ(host_.Ask("G1X200\nM71T1\nM17\n", 1.0), "ok\r\n");
  EXPECT_EQ(board_.lasers(), kDark);
  EXPECT_EQ(host_.Ask("?", 0.05).substr(0, 10), "<Run,MPos:");
  EXPECT_EQ(host_.ListenText(2.0), "ok\r\nok\r\n");
  EXPECT_EQ(board_.lasers(), (Lasers{true, false, false, false}));
  EXPECT_EQ(host_.Ask("?"), "<Idle,MPos:200.000,WPos:200.000>\r\n");
  EXPECT_EQ(host_.Ask("G50\n?"), "<Idle,MPos:200.000,WPos:200.000>\r\nok\r\n");
  EXPECT_EQ(host_.Ask("?"), "<Idle,MPos:0.000,WPos:0.000>\r\n");
}

TEST_F(HorusEmulatorTest, HoldsAndResumesAMove) {
  host_.Ask("G1F100X300\n", 1.0);
  host_.Ask("!", 1.0);
  const std::string held = host_.Ask("?");
  EXPECT_EQ(held.substr(0, 6), "<Hold,");
  EXPECT_EQ(host_.Ask("?"), held) << "it stands";
  EXPECT_EQ(host_.Ask("M71T1\n", 5.0), "") << "and what waits for it waits on";
  EXPECT_EQ(host_.Ask("~", 5.0), "ok\r\n");
  EXPECT_EQ(host_.Ask("?"), "<Idle,MPos:300.000,WPos:300.000>\r\n");
}

TEST_F(HorusEmulatorTest, AResetInMidMoveLocksItUntilUnlocked) {
  host_.Ask("G1F100X300\n", 0.5);
  const std::string reply = host_.Ask("\x18");
  EXPECT_NE(reply.find("ALARM: "), std::string::npos);
  EXPECT_NE(reply.find(kBanner), std::string::npos);
  EXPECT_EQ(host_.Ask("M71T1\n"), "error: Alarm lock\r\n");
  EXPECT_EQ(host_.Ask("?").substr(0, 7), "<Alarm,");
  EXPECT_EQ(host_.Ask("$X\n"), "[Caution: Unlocked]\r\nok\r\n");
  EXPECT_EQ(host_.Ask("M71T1\n"), "ok\r\n");
}

TEST_F(HorusEmulatorTest, ReadsItsLightSensorsAndSettings) {
  EXPECT_EQ(host_.Ask("M50T1\n"), "0\r\nok\r\n");
  EXPECT_EQ(host_.Ask("$120=150\n"), "ok\r\n");
  EXPECT_EQ(host_.Ask("$$\n"), "$120=150.000 (acceleration, deg/sec^2)\r\nok\r\n");
  EXPECT_NE(host_.Ask("$\n").find("ctrl-x"), std::string::npos);
  HorusEmulatorOptions options;
  options.light_sensor_counts = {120, 900};
  HorusEmulator lit(options);
  TestHost host(&lit);
  host.Listen(1.0);
  EXPECT_EQ(host.Ask("M50T2\n"), "900\r\nok\r\n");
}

TEST_F(HorusEmulatorTest, APowerCycleBootsItDark) {
  host_.Ask("M71T1\n");
  board_.PowerCycle(host_.now_s());
  EXPECT_EQ(board_.lasers(), kDark);
  EXPECT_EQ(host_.ListenText(1.0), kBanner);
}

TEST_F(HorusEmulatorTest, AnyNoiseLeavesItAnsweringInStep) {
  NoiseSource noise(7);
  const std::string letters = "GMTFX0123456789.-+$=?!~()/ \r\n\x18";
  for (int i = 0; i < 10000; ++i) {
    std::string text(noise.Bits() % 20, ' ');
    for (char& c : text) {
      c = noise.Chance(0.7) ? letters[noise.Bits() % letters.size()]
                            : static_cast<char>(noise.Bits() & 0xff);
    }
    host_.Send(text);
    host_.Listen(0.01);
    ASSERT_NE(host_.Ask("\n\x18\n$X\n", 0.03).find("ok\r\n"), std::string::npos) << i;
    ASSERT_EQ(host_.Ask("M70T1\n", 0.01), "ok\r\n") << "string " << i << ": " << text;
  }
}

}  // namespace
}  // namespace geon::sim
