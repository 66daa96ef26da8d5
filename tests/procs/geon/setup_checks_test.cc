#include "procs/geon/setup_checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "config/daemon_arguments.h"
#include "config/text_file.h"

namespace geon::cli {
namespace {

using testing::HasSubstr;
using State = SetupCheck::State;

class SetupChecksTest : public testing::Test {
 protected:
  void SetUp() override {
    dir_ = std::filesystem::temp_directory_path() /
           ("geon_setup_checks_" + std::to_string(::getpid()));
    std::filesystem::create_directories(dir_ / "calibration");
    std::filesystem::copy(config::InstalledFile("scripts/config/calibration/rig.yaml"),
                          dir_ / "calibration");
    text_ = *config::ReadFile(config::InstalledFile("scripts/config/robot.yaml"));
  }
  void TearDown() override { std::filesystem::remove_all(dir_); }

  // The installed robot file with one piece of text replaced, in a folder of its own.
  std::filesystem::path RobotFile(const std::string& from, const std::string& to) {
    std::string text = text_;
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    EXPECT_TRUE(config::WriteFileAtomically(dir_ / "robot.yaml", text).ok());
    return dir_ / "robot.yaml";
  }
  std::filesystem::path dir_;
  std::string text_;
};

TEST_F(SetupChecksTest, TheInstalledCalibrationIsGood) {
  const auto checks = CheckCalibrations(config::InstalledFile("scripts/config/robot.yaml"));
  ASSERT_FALSE(checks.empty());
  for (const SetupCheck& check : checks) EXPECT_NE(check.state, State::kBad) << check.text;
}

TEST_F(SetupChecksTest, MissingTablesAreBad) {
  const auto checks = CheckCalibrations(RobotFile("ranging: rig", "ranging: lut"));
  EXPECT_EQ(checks.back().state, State::kBad);
  EXPECT_THAT(checks.back().text, HasSubstr("horizontal.lut"));
}

TEST_F(SetupChecksTest, DevicesThatAreNotThereAreNamed) {
  const auto checks =
      CheckDevices(RobotFile("/dev/serial/by-path/ptu", (dir_ / "robot.yaml").string()));
  ASSERT_EQ(checks.size(), 6U);
  EXPECT_EQ(checks[0].name, "pan-tilt unit");
  EXPECT_EQ(checks[0].state, State::kGood);
  EXPECT_EQ(checks[1].state, State::kNotReady);
  EXPECT_THAT(checks[1].text, HasSubstr("/dev/serial/by-path/base is not there"));
}

TEST_F(SetupChecksTest, TheBusIsJudgedByWhatTheKernelGrants) {
  const auto good = CheckBus(RobotFile("recv_buf_size=4194304", "recv_buf_size=1000"));
  ASSERT_EQ(good.size(), 1U);
  EXPECT_EQ(good[0].name, "receive buffer");
  EXPECT_EQ(good[0].state, State::kNotReady);
}

}  // namespace
}  // namespace geon::cli
