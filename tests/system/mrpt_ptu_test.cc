// Other people's driver against our pan-tilt unit: MRPT's Directed Perception client opens the
// simulated unit's serial line and drives it in real time.
#include <gtest/gtest.h>
#include <mrpt/hwdrivers/CPtuDPerception.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "base/angles.h"
#include "procs/simulator/pty_port.h"
#include "sim/ptu_emulator.h"

namespace geon {
namespace {

using std::chrono::milliseconds;

constexpr double kCount_rad = RadiansFromDegrees(185.1428 / 3600.0);

// The unit on a pseudo-terminal, in real time.
class LivePtu {
 public:
  explicit LivePtu(const std::filesystem::path& link)
      : port_(simulator::PtyPort::Open(link, 9600).value()), thread_([this] { Run(); }) {}
  ~LivePtu() {
    stop_ = true;
    thread_.join();
  }
  double pan_rad() const {
    const std::lock_guard lock(mutex_);
    return ptu_.pan_rad();
  }
  double tilt_rad() const {
    const std::lock_guard lock(mutex_);
    return ptu_.tilt_rad();
  }
  bool moving() const {
    const std::lock_guard lock(mutex_);
    return ptu_.moving();
  }

 private:
  void Run() {
    const auto start = std::chrono::steady_clock::now();
    while (!stop_) {
      const std::chrono::duration<double> now = std::chrono::steady_clock::now() - start;
      {
        const std::lock_guard lock(mutex_);
        ptu_.Receive(port_.Read().bytes, now.count());
        ptu_.Advance(now.count());
        port_.Write(ptu_.Transmit(now.count()));
      }
      std::this_thread::sleep_for(milliseconds(1));
    }
  }

  mutable std::mutex mutex_;
  sim::PtuEmulator ptu_;
  simulator::PtyPort port_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

class MrptPtuTest : public ::testing::Test {
 protected:
  static std::filesystem::path MakeFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "mrpt_ptu_XXXXXX").string();
    return mkdtemp(name.data());
  }
  void SetUp() override {
    client_.clearErrors();  // MRPT does not start with none
    ASSERT_TRUE(client_.init((folder_ / "ptu.tty").string()));
  }
  void TearDown() override {
    client_.close();
    std::filesystem::remove_all(folder_);
  }
  bool StandsWithin(milliseconds limit) const {
    const auto deadline = std::chrono::steady_clock::now() + limit;
    while (std::chrono::steady_clock::now() < deadline) {
      if (!unit_.moving()) return true;
      std::this_thread::sleep_for(milliseconds(20));
    }
    return false;
  }

  std::filesystem::path folder_ = MakeFolder();
  LivePtu unit_{folder_ / "ptu.tty"};
  mrpt::hwdrivers::CPtuDPerception client_;
};

TEST_F(MrptPtuTest, InitialisesAndReadsResolutionModesAndVersion) {
  // MRPT keeps the resolutions to itself; what it converts with them shows that it has read them.
  EXPECT_EQ(client_.radToPos('P', 1000.5 * kCount_rad), 1000);
  bool on = false;
  EXPECT_TRUE(client_.verboseQ(on));
  EXPECT_TRUE(on);
  on = false;
  EXPECT_TRUE(client_.echoModeQ(on));
  EXPECT_TRUE(on);
  char version[150] = "";
  EXPECT_TRUE(client_.version(version));
  EXPECT_NE(std::string(version).find("Pan-Tilt"), std::string::npos);
  EXPECT_TRUE(client_.noError());
}

TEST_F(MrptPtuTest, MovesToAbsolutePositionsAndReadsThemBack) {
  const double pan_rad = 400.5 * kCount_rad;
  const double tilt_rad = -300.5 * kCount_rad;
  ASSERT_TRUE(client_.moveToAbsPos('P', pan_rad));
  ASSERT_TRUE(client_.moveToAbsPos('T', tilt_rad));
  ASSERT_TRUE(StandsWithin(milliseconds(3000)));
  EXPECT_NEAR(unit_.pan_rad(), 400 * kCount_rad, 1e-9);
  EXPECT_NEAR(unit_.tilt_rad(), -300 * kCount_rad, 1e-9);
  double read_rad = 0.0;
  ASSERT_TRUE(client_.absPosQ('P', read_rad));
  EXPECT_NEAR(read_rad, 400 * kCount_rad, 1e-9);
  ASSERT_TRUE(client_.absPosQ('T', read_rad));
  EXPECT_NEAR(read_rad, -300 * kCount_rad, 1e-9);
  ASSERT_TRUE(client_.moveToOffPos('P', -150.5 * kCount_rad));
  ASSERT_TRUE(client_.aWait());
  ASSERT_TRUE(client_.absPosQ('P', read_rad));
  EXPECT_NEAR(read_rad, 250 * kCount_rad, 1e-9);
  ASSERT_TRUE(client_.offPosQ('P', read_rad));
  EXPECT_NEAR(read_rad, 250 * kCount_rad, 1e-9);
}

TEST_F(MrptPtuTest, SetsAndReadsSpeeds) {
  double read_rad_s = 0.0;
  ASSERT_TRUE(client_.speedQ('P', read_rad_s));
  EXPECT_NEAR(read_rad_s, 1000 * kCount_rad, 1e-9);
  ASSERT_TRUE(client_.speed('P', 200.5 * kCount_rad));
  ASSERT_TRUE(client_.speedQ('P', read_rad_s));
  EXPECT_NEAR(read_rad_s, 200 * kCount_rad, 1e-9);
  ASSERT_TRUE(client_.upperSpeedQ('T', read_rad_s));
  EXPECT_NEAR(read_rad_s, 2902 * kCount_rad, 1e-9);
  ASSERT_TRUE(client_.lowerSpeedQ('T', read_rad_s));
  EXPECT_NEAR(read_rad_s, 31 * kCount_rad, 1e-9);
  ASSERT_TRUE(client_.acelerationQ('T', read_rad_s));
  EXPECT_NEAR(read_rad_s, 2000 * kCount_rad, 1e-9);
  ASSERT_TRUE(client_.aceleration('T', 1500.5 * kCount_rad));
  ASSERT_TRUE(client_.acelerationQ('T', read_rad_s));
  EXPECT_NEAR(read_rad_s, 1500 * kCount_rad, 1e-9);
  // Half a second at 200 counts a second.
  ASSERT_TRUE(client_.moveToAbsPos('P', 100.5 * kCount_rad));
  EXPECT_TRUE(unit_.moving());
  ASSERT_TRUE(StandsWithin(milliseconds(3000)));
  EXPECT_FALSE(client_.speed('P', 5000 * kCount_rad));
  EXPECT_TRUE(client_.unExpectedError());
  EXPECT_FALSE(client_.maxLimitError());
}

TEST_F(MrptPtuTest, KnowsTheLimitsAndIsRefusedBeyondThem) {
  double read_rad = 0.0;
  ASSERT_TRUE(client_.maxPosQ('P', read_rad));
  EXPECT_NEAR(read_rad, 3090 * kCount_rad, 1e-9);
  ASSERT_TRUE(client_.minPosQ('T', read_rad));
  EXPECT_NEAR(read_rad, -907 * kCount_rad, 1e-9);
  bool enabled = false;
  ASSERT_TRUE(client_.enableLimitsQ(enabled));
  EXPECT_TRUE(enabled);
  EXPECT_FALSE(client_.moveToAbsPos('T', 700 * kCount_rad));
  EXPECT_TRUE(client_.maxLimitError());
  client_.clearErrors();
  EXPECT_FALSE(client_.moveToAbsPos('P', -3200 * kCount_rad));
  EXPECT_TRUE(client_.minLimitError());
  EXPECT_FALSE(unit_.moving());
  client_.clearErrors();
  ASSERT_TRUE(client_.enableLimits(false));
  ASSERT_TRUE(client_.enableLimitsQ(enabled));
  EXPECT_FALSE(enabled);
  ASSERT_TRUE(client_.enableLimits(true));
}

TEST_F(MrptPtuTest, ResetsAndIsInStepAfterwards) {
  ASSERT_TRUE(client_.moveToAbsPos('P', 300.5 * kCount_rad));
  ASSERT_TRUE(StandsWithin(milliseconds(3000)));
  // MRPT waits a second for each character; the unit, like a real one, hunts for its stops longer.
  client_.reset();
  ASSERT_TRUE(StandsWithin(milliseconds(30000)));
  EXPECT_NEAR(unit_.pan_rad(), 0.0, 1e-12);
  EXPECT_NEAR(unit_.tilt_rad(), 0.0, 1e-12);
  client_.clearErrors();
  double read_rad = 1.0;
  ASSERT_TRUE(client_.absPosQ('P', read_rad));
  EXPECT_EQ(read_rad, 0.0);
  ASSERT_TRUE(client_.moveToAbsPos('T', 100.5 * kCount_rad));
  ASSERT_TRUE(StandsWithin(milliseconds(3000)));
  ASSERT_TRUE(client_.absPosQ('T', read_rad));
  EXPECT_NEAR(read_rad, 100 * kCount_rad, 1e-9);
}

TEST_F(MrptPtuTest, HaltsInMidMotion) {
  ASSERT_TRUE(client_.moveToAbsPos('P', 2000.5 * kCount_rad));
  ASSERT_TRUE(client_.halt('P'));
  ASSERT_TRUE(StandsWithin(milliseconds(2000)));
  EXPECT_LT(unit_.pan_rad(), 1500 * kCount_rad);
  ASSERT_TRUE(client_.haltAll());
}

}  // namespace
}  // namespace geon
