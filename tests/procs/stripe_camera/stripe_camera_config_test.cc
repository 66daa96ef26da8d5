#include "procs/stripe_camera/stripe_camera_config.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/procs/installed_robot_file.h"

namespace geon::stripe_camera {
namespace {

Result<StripeCameraConfig> Load(const std::string& text, const StripeCameraFlags& flags = {}) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "geon_stripe_camera_config_test.yaml";
  std::ofstream(path) << text;
  config::DaemonArguments arguments("geon-stripe-camera", "test", "test");
  arguments.config_file = path;
  auto config = LoadStripeCameraConfig(arguments, flags);
  std::filesystem::remove(path);
  return config;
}

TEST(StripeCameraConfig, TheInstalledFileIsGood) {
  const auto config = Load(InstalledRobotFile());
  ASSERT_TRUE(config.ok()) << config.message();
  EXPECT_EQ(config->source.width_px, 640);
  EXPECT_EQ(config->source.format, sensor::PixelFormat::kGray8);
  EXPECT_EQ(config->lasers.path, "/dev/ttyUSB0");
  EXPECT_EQ(config->lasers.baud, 115200);
  EXPECT_EQ(config->capture.request_timeout_s, 1.0);
  EXPECT_EQ(config->capture.proof.min_lit_lines, 24);
}

TEST(StripeCameraConfig, FlagsWin) {
  const auto config = Load(InstalledRobotFile(), {"sim:ipc:///tmp/x", "/tmp/lasers.tty"});
  ASSERT_TRUE(config.ok()) << config.message();
  EXPECT_EQ(config->source.source, "sim:ipc:///tmp/x");
  EXPECT_EQ(config->lasers.path, "/tmp/lasers.tty");
}

TEST(StripeCameraConfig, BadValuesAreRefusedByName) {
  std::string text = InstalledRobotFile();
  const std::string good = "lit_tries: 3";
  text.replace(text.find(good), good.size(), "lit_tries: 0");
  const auto config = Load(text);
  ASSERT_FALSE(config.ok());
  EXPECT_NE(config.message().find("lit_tries"), std::string::npos) << config.message();
}

TEST(StripeCameraConfig, UnknownKeysAreRefused) {
  std::string text = InstalledRobotFile();
  const std::string section = "\nstripe_camera:\n";
  text.insert(text.find(section) + section.size(), "  lazers: 2\n");
  const auto config = Load(text);
  ASSERT_FALSE(config.ok());
  EXPECT_NE(config.message().find("lazers"), std::string::npos) << config.message();
}

}  // namespace
}  // namespace geon::stripe_camera
