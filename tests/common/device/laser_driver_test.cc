#include "device/laser_driver.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/common/device/virtual_line.h"

namespace geon::device {
namespace {

using sensor::DeviceStatus;
using sensor::Laser;

// The least of a Horus board, after its firmware's description, for tests of the driver.
struct ScriptedBoard {
  bool alive = true;
  bool lit[2] = {false, false};
  bool ever_both = false;
  int drop_replies = 0;
  std::string override_next;
  std::string banner = "\r\nHorus 0.2 ['$' for help]\r\n";
  double booting_until_s = 0.0;

  std::string Restart() {
    lit[0] = lit[1] = false;
    line_.clear();
    return banner;
  }
  std::string Step(double time_s, const std::string& heard) {
    if (!alive) return {};
    if (time_s < booting_until_s) {
      booting_ = true;
      return {};  // the boot loader swallows everything
    }
    std::string said;
    if (std::exchange(booting_, false)) said += Restart();
    for (const char c : heard) {
      if (c == '\x18') {
        said += Restart();
      } else if (c == '\r' || c == '\n') {
        if (!line_.empty()) said += Obey(std::exchange(line_, {}));
      } else {
        line_ += c;
      }
    }
    ever_both |= lit[0] && lit[1];
    return said;
  }

 private:
  std::string Obey(const std::string& line) {
    std::string reply = "error: Unsupported command\r\n";
    if (line.size() == 5 && (line.starts_with("M70T") || line.starts_with("M71T"))) {
      const int laser = line[4] - '1';
      if (laser == 0 || laser == 1) lit[laser] = line[2] == '1';
      reply = "ok\r\n";
    }
    if (!override_next.empty()) return std::exchange(override_next, {});
    if (drop_replies > 0) {
      --drop_replies;
      return {};
    }
    return reply;
  }
  bool booting_ = false;
  std::string line_;
};

class LaserDriverTest : public testing::Test {
 protected:
  ~LaserDriverTest() override { EXPECT_FALSE(board_.ever_both); }
  bool Ready() const { return driver_.report().status == DeviceStatus::kReady; }
  bool Confirms(Laser laser, double limit_s = 6.0) {
    driver_.Request(laser);
    return line_.RunUntil(
        [&] { return driver_.report().confirmed && driver_.report().laser == laser; }, limit_s);
  }

  ScriptedBoard board_;
  LaserDriver driver_;
  VirtualLine<LaserDriver> line_{
      &driver_, [this](double t, const std::string& heard) { return board_.Step(t, heard); }};
};

TEST_F(LaserDriverTest, StartsWithBothOffAndConfirmed) {
  board_.lit[1] = true;  // left burning by whoever was here before
  EXPECT_FALSE(driver_.report().confirmed);
  ASSERT_TRUE(Confirms(Laser::kNone, 1.0));
  EXPECT_FALSE(board_.lit[0] || board_.lit[1]);
  EXPECT_EQ(driver_.report().restarts, 0);
}

TEST_F(LaserDriverTest, WaitsForABoardWhoseBootLoaderSwallowsTheFirstWords) {
  board_.booting_until_s = line_.time_s() + 1.5;
  EXPECT_TRUE(Confirms(Laser::kHorizontal, 3.0));
}

TEST_F(LaserDriverTest, SwitchesOneLaserAtATimeWithTheTimeOfTheOk) {
  ASSERT_TRUE(Confirms(Laser::kHorizontal));
  EXPECT_TRUE(board_.lit[0] && !board_.lit[1]);
  const double lit_s = driver_.report().confirmed_time_s;
  EXPECT_NEAR(lit_s, line_.time_s(), 0.01);
  ASSERT_TRUE(Confirms(Laser::kVertical, 0.2));
  EXPECT_TRUE(!board_.lit[0] && board_.lit[1]);
  EXPECT_GT(driver_.report().confirmed_time_s, lit_s);
  const double changed_s = driver_.report().confirmed_time_s;
  line_.Run(3.0);
  EXPECT_EQ(driver_.report().confirmed_time_s, changed_s) << "saying it again is no change";
  ASSERT_TRUE(Confirms(Laser::kNone, 0.2));
  EXPECT_FALSE(board_.lit[0] || board_.lit[1]);
  EXPECT_NEAR(driver_.report().on_time_s, 3.0, 0.2);
}

TEST_F(LaserDriverTest, KeepsTalkingSoThatTheBoardsTimeOutNeverStrikesUnnoticed) {
  ASSERT_TRUE(Confirms(Laser::kHorizontal));
  line_.TakeTraffic();
  line_.Run(10.0);
  const std::string traffic = line_.TakeTraffic();
  EXPECT_NE(traffic.find("M71T1"), std::string::npos);
  EXPECT_EQ(traffic.find("M71T2"), std::string::npos);
}

TEST_F(LaserDriverTest, ABannerMeansDarkUntilTheStateHasBeenSaidAgain) {
  ASSERT_TRUE(Confirms(Laser::kHorizontal));
  const double lit_s = driver_.report().confirmed_time_s;
  line_.Inject(board_.Restart());
  line_.Run(VirtualLine<LaserDriver>::kStep_s);
  EXPECT_FALSE(driver_.report().confirmed);
  EXPECT_EQ(driver_.report().restarts, 1);
  ASSERT_TRUE(Confirms(Laser::kHorizontal, 0.5));
  EXPECT_TRUE(board_.lit[0]);
  EXPECT_GT(driver_.report().confirmed_time_s, lit_s);
}

TEST_F(LaserDriverTest, AMissingOkLeavesTheLaserSuspectAndIsSaidAgain) {
  ASSERT_TRUE(Confirms(Laser::kNone));
  board_.drop_replies = 1;
  driver_.Request(Laser::kVertical);
  line_.Run(0.1);
  EXPECT_FALSE(driver_.report().confirmed);
  EXPECT_EQ(driver_.report().laser, Laser::kVertical) << "it may burn";
  ASSERT_TRUE(Confirms(Laser::kVertical, 2.0));
  EXPECT_EQ(driver_.report().errors, 1);
}

TEST_F(LaserDriverTest, AnErrorIsNeverTakenForSuccess) {
  ASSERT_TRUE(Confirms(Laser::kNone));
  for (const std::string bad :
       {"error: Bad number format\r\n", "ALARM: x\r\n", "k\r\n", "ok?\r\n"}) {
    board_.override_next = bad;
    driver_.Request(Laser::kHorizontal);
    line_.Run(0.05);
    EXPECT_FALSE(driver_.report().confirmed) << bad;
    EXPECT_NE(driver_.report().status, DeviceStatus::kReady) << bad;
    ASSERT_TRUE(Confirms(Laser::kHorizontal)) << bad;
    ASSERT_TRUE(Confirms(Laser::kNone)) << bad;
  }
}

TEST_F(LaserDriverTest, TwoAnswersToOneLineDoNotShiftTheOthers) {
  ASSERT_TRUE(Confirms(Laser::kNone));
  board_.override_next = "error: Line overflow\r\nerror: Bad number format\r\n";
  driver_.Request(Laser::kHorizontal);
  line_.Run(3.0);
  ASSERT_TRUE(Confirms(Laser::kHorizontal));
  line_.Inject("ok\r\n");
  line_.Run(0.01);
  EXPECT_FALSE(driver_.report().confirmed) << "an ok nobody asked for";
  ASSERT_TRUE(Confirms(Laser::kHorizontal));
}

TEST_F(LaserDriverTest, AForeignFirmwareIsAFaultWithAName) {
  board_.banner = "\r\nHorus 0.1 ['$' for help]\r\n";
  line_.Run(3.0);
  EXPECT_EQ(driver_.report().status, DeviceStatus::kFault);
  EXPECT_NE(driver_.report().text.find("Horus 0.1"), std::string::npos);
  EXPECT_FALSE(board_.lit[0] || board_.lit[1]);
}

TEST_F(LaserDriverTest, SilenceIsAFaultAndTheSuspectStays) {
  ASSERT_TRUE(Confirms(Laser::kHorizontal));
  board_.alive = false;
  ASSERT_TRUE(
      line_.RunUntil([&] { return driver_.report().status == DeviceStatus::kFault; }, 30.0));
  EXPECT_EQ(driver_.report().laser, Laser::kHorizontal);
  EXPECT_FALSE(driver_.report().confirmed);
  board_.alive = true;
  EXPECT_TRUE(Confirms(Laser::kNone));
}

TEST_F(LaserDriverTest, ALineThatComesBackStartsDark) {
  ASSERT_TRUE(Confirms(Laser::kHorizontal));
  driver_.Disconnected(line_.time_s());
  EXPECT_EQ(driver_.report().status, DeviceStatus::kUnknown);
  EXPECT_EQ(driver_.report().laser, Laser::kHorizontal) << "nobody has switched it off";
  driver_.Connected(line_.time_s());
  ASSERT_TRUE(line_.RunUntil([&] { return driver_.report().confirmed; }, 4.0));
  EXPECT_EQ(driver_.report().laser, Laser::kNone);
  EXPECT_FALSE(board_.lit[0]);
}

TEST_F(LaserDriverTest, NeverBothLitWhateverIsAskedAndWhateverGoesWrong) {
  std::mt19937 random(6);
  for (int i = 0; i < 20'000; ++i) {
    switch (random() % 12) {
      case 0:
        board_.drop_replies = 1;
        break;
      case 1:
        line_.Inject(random() % 2 ? "ok\r\n" : "error: x\r\n");
        break;
      case 2:
        if (random() % 10 == 0) line_.Inject(board_.Restart());
        break;
      default:
        driver_.Request(static_cast<Laser>(random() % 3));
    }
    line_.Run(0.005 * static_cast<double>(1 + random() % 10));
    const LaserReport& report = driver_.report();
    if (report.confirmed && report.laser == Laser::kNone) {
      ASSERT_FALSE(board_.lit[0] || board_.lit[1]) << "said to be dark";
    }
  }
  EXPECT_TRUE(Confirms(Laser::kNone, 10.0));
  EXPECT_FALSE(board_.lit[0] || board_.lit[1]);
}

TEST_F(LaserDriverTest, TenThousandRandomStringsLeaveItInStep) {
  std::mt19937 random(7);
  const std::string alphabet = "okerr:\r\n[<Hus 0.2";
  for (int i = 0; i < 10'000; ++i) {
    std::string noise(1 + random() % 20, '\0');
    for (char& byte : noise) {
      byte = random() % 2 ? alphabet[random() % alphabet.size()] : static_cast<char>(random());
    }
    line_.Inject(noise);
    line_.Run(0.02);
  }
  ASSERT_TRUE(Confirms(Laser::kVertical, 10.0));
  EXPECT_TRUE(board_.lit[1]);
}

}  // namespace
}  // namespace geon::device
