#include "sim/ptu_emulator.h"

#include <gtest/gtest.h>

#include "base/angles.h"
#include "sim/noise_source.h"
#include "tests/common/sim/device_testing.h"

namespace geon::sim {
namespace {

class PtuEmulatorTest : public ::testing::Test {
 protected:
  PtuEmulatorTest() { banner_ = host_.ListenText(0.5); }
  void Quiet() { host_.Ask("ED FT "); }

  PtuEmulator ptu_;
  TestHost host_{&ptu_};
  std::string banner_;
};

TEST_F(PtuEmulatorTest, IntroducesItself) {
  EXPECT_NE(banner_.find("PAN-TILT"), std::string::npos);
}

TEST_F(PtuEmulatorTest, EchoesAndTalksAtFirst) {
  EXPECT_EQ(host_.Ask("PP "), "PP * Current Pan position is 0\r\n");
  EXPECT_EQ(host_.Ask("tp\r"), "tp\r* Current Tilt position is 0\r\n");
}

TEST_F(PtuEmulatorTest, IsTerseAndSilentWhenTold) {
  EXPECT_EQ(host_.Ask("ED "), "ED *\r\n");
  EXPECT_EQ(host_.Ask("FT "), "*\r\n");
  EXPECT_EQ(host_.Ask("PP "), "* 0\r\n");
  EXPECT_EQ(host_.Ask("PR\n"), "* 185.1428\r\n");
  EXPECT_EQ(host_.Ask("pp\r\n"), "* 0\r\n") << "CR LF is one end, the empty word says nothing";
  EXPECT_EQ(host_.Ask("  \r\n "), "");
  EXPECT_EQ(host_.Ask("PP TP "), "* 0\r\n* 0\r\n");
}

TEST_F(PtuEmulatorTest, BytesTakeTheirTime) {
  Quiet();
  host_.Send("PP ");
  // 3 bytes there and 5 back at about 1.04 ms each, and 2 ms to think.
  EXPECT_EQ(host_.ListenText(0.010), "* 0");
  EXPECT_EQ(host_.ListenText(0.004), "\r\n");
}

TEST_F(PtuEmulatorTest, MovesInRealTimeAndTellsWhereItIs) {
  Quiet();
  EXPECT_EQ(host_.Ask("PP1000 "), "*\r\n");
  host_.Listen(0.3);
  EXPECT_GT(ptu_.pan_rad(), 0.05);
  EXPECT_TRUE(ptu_.moving());
  host_.Listen(1.2);
  EXPECT_EQ(host_.Ask("PP "), "* 1000\r\n");
  EXPECT_NEAR(DegreesFromRadians(ptu_.pan_rad()), 51.4286, 1e-3);
  EXPECT_FALSE(ptu_.moving());
}

TEST_F(PtuEmulatorTest, RefusesInWordsAndDoesNotMove) {
  Quiet();
  EXPECT_EQ(host_.Ask("TP700 "), "! Maximum allowable Tilt position is 604\r\n");
  EXPECT_EQ(host_.Ask("PP1x "), "! Illegal argument\r\n");
  EXPECT_EQ(host_.Ask("XYZ "), "! Illegal Command Entered\r\n");
  EXPECT_EQ(host_.Ask("\xff\xfe "), "! Illegal Command Entered\r\n");
  EXPECT_EQ(host_.Ask(std::string(300, 'P') + " ", 0.6), "! Illegal Command Entered\r\n");
  EXPECT_FALSE(ptu_.moving());
}

TEST_F(PtuEmulatorTest, AwaitAnswersOnArrivalAndHoldsWhatFollows) {
  Quiet();
  EXPECT_EQ(host_.Ask("PP1000 A PP ", 0.5), "*\r\n");
  EXPECT_EQ(host_.ListenText(1.5), "*\r\n* 1000\r\n");
}

TEST_F(PtuEmulatorTest, ResetEndsWithTheNineCharactersDriversWaitFor) {
  Quiet();
  host_.Ask("PP500 ", 2.0);
  host_.Send("R ");
  const std::string early = host_.ListenText(3.0);
  EXPECT_EQ(early.find('*'), std::string::npos) << "it takes a while";
  EXPECT_EQ(early + host_.ListenText(20.0), "!T!T!P!P*\r\n");
  EXPECT_EQ(host_.Ask("PP "), "* 0\r\n");
  EXPECT_NEAR(ptu_.pan_rad(), 0.0, 1e-12);
}

TEST(PtuEmulator, SomeFirmwareEndsAResetWithABareStar) {
  PtuEmulatorOptions options;
  options.reset_ends_with_newline = false;
  PtuEmulator ptu(options);
  TestHost host(&ptu);
  host.Ask("ED FT ", 0.5);
  EXPECT_EQ(host.Ask("R ", 25.0), "!T!T!P!P*");
}

TEST_F(PtuEmulatorTest, AStallIsReportedAndTheCounterLiesUntilReset) {
  Quiet();
  ptu_.StallPan(200);
  EXPECT_EQ(host_.Ask("PP "), "!P* 0\r\n");
  EXPECT_NEAR(DegreesFromRadians(ptu_.pan_rad()), -200 * 185.1428 / 3600.0, 1e-9);
  host_.Ask("R ", 25.0);
  EXPECT_NEAR(ptu_.pan_rad(), 0.0, 1e-12);
}

TEST_F(PtuEmulatorTest, RaisingTheSpeedCapTakesSecondsOfDeafness) {
  Quiet();
  EXPECT_EQ(host_.Ask("PU5833 PP ", 5.5), "");
  EXPECT_EQ(host_.ListenText(1.0), "*\r\n* 0\r\n");
}

TEST_F(PtuEmulatorTest, TablesAreNotChangedInMidMotion) {
  Quiet();
  EXPECT_EQ(host_.Ask("PP1000 PA4000 ", 1.0), "*\r\n") << "the move still runs";
  EXPECT_EQ(host_.ListenText(2.0), "*\r\n");
  EXPECT_EQ(host_.Ask("PA "), "* 4000\r\n");
}

TEST_F(PtuEmulatorTest, AnyCharacterEndsTheMonitor) {
  Quiet();
  EXPECT_EQ(host_.Ask("M-500,500 ", 3.0), "*\r\n");
  EXPECT_TRUE(ptu_.moving());
  host_.Ask(" ", 3.0);
  EXPECT_FALSE(ptu_.moving());
  EXPECT_EQ(host_.Ask("PP "), "* 0\r\n");
}

TEST_F(PtuEmulatorTest, AUnitThatIsNotSpokenToKeepsItsMouthShut) {
  Quiet();
  EXPECT_EQ(host_.Ask("U3 "), "*\r\n");
  EXPECT_EQ(host_.Ask("_5 PP "), "");
  ptu_.StallTilt(10);
  EXPECT_EQ(host_.Ask("_3 "), "!T") << "what it kept for later";
  EXPECT_EQ(host_.Ask("PP "), "* 0\r\n");
  // The rescue of a mute unit.
  host_.Ask("_9 ");
  EXPECT_EQ(host_.Ask("   _0 u0 DS "), "*\r\n*\r\n");
  EXPECT_EQ(host_.Ask("_9 PP "), "* 0\r\n") << "unit 0 always answers";
}

TEST_F(PtuEmulatorTest, ExpansionPortsCanBeSetUp) {
  Quiet();
  EXPECT_EQ(host_.Ask("@A(9600,8,N,F) "), "*\r\n");
  EXPECT_EQ(host_.Ask("@C(9600,8,N,F) "), "! Illegal Command Entered\r\n");
}

TEST_F(PtuEmulatorTest, APowerCycleHuntsInSilenceThenEchoesAgain) {
  Quiet();
  host_.Ask("PP700 ", 2.0);
  ptu_.PowerCycle(host_.now_s());
  EXPECT_EQ(host_.Ask("PP ", 3.0), "") << "deaf and silent";
  EXPECT_NE(host_.ListenText(20.0).find("PAN-TILT"), std::string::npos);
  EXPECT_EQ(host_.Ask("PP "), "PP * Current Pan position is 0\r\n");
  EXPECT_NEAR(ptu_.pan_rad(), 0.0, 1e-12);
}

TEST(PtuEmulator, MayHaveItsPowerUpResetAhead) {
  PtuEmulatorOptions options;
  options.starts_with_reset = true;
  PtuEmulator ptu(options);
  TestHost host(&ptu);
  EXPECT_EQ(host.ListenText(2.0), "");
  EXPECT_TRUE(ptu.moving());
  EXPECT_NE(host.ListenText(20.0).find("PAN-TILT"), std::string::npos);
}

TEST_F(PtuEmulatorTest, AnyNoiseLeavesItAnsweringInStep) {
  NoiseSource noise(99);
  const std::string letters = "PTHRLEFVOCISADMUXN_@?!*0123456789-,. \r\n";
  Quiet();
  for (int i = 0; i < 10000; ++i) {
    std::string text(noise.Bits() % 12, ' ');
    for (char& c : text) {
      c = noise.Chance(0.7) ? letters[noise.Bits() % letters.size()]
                            : static_cast<char>(noise.Bits() & 0xff);
    }
    host_.Send(text + " ");
    // A reset, an await or new tables may keep it busy for a while; then it must be all ears.
    for (int wait = 0; wait < 2000 && !host_.ListenText(0.05).empty(); ++wait) {
    }
    const std::string reply = host_.Ask("\r_0 ED FT U0 CI I H TR ", 0.15);
    if (reply.find("* 185.1428\r\n") == std::string::npos) {
      const std::string late = reply + host_.ListenText(240.0);
      ASSERT_NE(late.find("* 185.1428\r\n"), std::string::npos) << "string " << i << ": " << text;
    }
    const std::string next = host_.Ask("PR ", 0.05);
    ASSERT_EQ(next, "* 185.1428\r\n") << "string " << i << ": " << text;
  }
}

}  // namespace
}  // namespace geon::sim
