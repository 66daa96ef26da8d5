#include "procs/color_camera/color_camera_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/procs/installed_robot_file.h"

namespace geon::color_camera {
namespace {

Result<ColorCameraConfig> Load(const std::string& text, Role role,
                               const ColorCameraFlags& flags = {}) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "geon_color_camera_config_test.yaml";
  std::ofstream(path) << text;
  config::DaemonArguments arguments("geon-color-camera", "test", "test");
  arguments.config_file = path;
  auto config = LoadColorCameraConfig(arguments, role, flags);
  std::filesystem::remove(path);
  return config;
}

TEST(ColorCameraConfig, TheInstalledFileIsGoodForBothCameras) {
  const auto head = Load(InstalledRobotFile(), Role::kHead);
  ASSERT_TRUE(head.ok()) << head.message();
  EXPECT_EQ(head->source.width_px, 640);
  EXPECT_EQ(head->encoding, sensor::PixelFormat::kBgr8);
  EXPECT_EQ(head->source.controls.exposure_s, 0.010);
  EXPECT_EQ(head->source.controls.white_balance_k, 4000);
  const auto floor = Load(InstalledRobotFile(), Role::kFloor);
  ASSERT_TRUE(floor.ok()) << floor.message();
  EXPECT_EQ(floor->source.width_px, 320);
}

// The installed file with one text in place of another.
std::string With(const std::string& good, const std::string& other) {
  std::string text = InstalledRobotFile();
  EXPECT_NE(text.find(good), std::string::npos) << good;
  return text.replace(text.find(good), good.size(), other);
}

TEST(ColorCameraConfig, TheHeadsExposureFollowsTheTargetUnlessFixed) {
  const auto head = Load(InstalledRobotFile(), Role::kHead);
  ASSERT_TRUE(head.ok() && head->exposure.has_value()) << head.message();
  EXPECT_EQ(head->exposure->target_color.name, "super-red");
  EXPECT_EQ(head->exposure->first_exposure_s, 0.010);
  EXPECT_EQ(head->exposure->law.most_exposure_s, 0.050);
  EXPECT_FALSE(Load(InstalledRobotFile(), Role::kFloor)->exposure.has_value());

  const auto fixed = Load(With("exposure: target", "exposure: fixed"), Role::kHead);
  ASSERT_TRUE(fixed.ok()) << fixed.message();
  EXPECT_FALSE(fixed->exposure.has_value());
  const auto silent = Load(With("  exposure: target\n", ""), Role::kHead);
  EXPECT_TRUE(silent->exposure.has_value()) << silent.message();
}

TEST(ColorCameraConfig, BadExposuresAreRefusedByName) {
  const auto message = [](const std::string& good, const std::string& bad) {
    return Load(With(good, bad), Role::kHead).message();
  };
  EXPECT_THAT(message("exposure: target", "exposure: auto"),
              testing::HasSubstr("'exposure' must be target or fixed"));
  for (const char* range : {"[0.05, 0.0005]", "[0.0, 0.05]", "[0.05]", "0.05"}) {
    EXPECT_THAT(message("[0.0005, 0.050]", range), testing::HasSubstr("exposure_range_s"));
  }
  EXPECT_THAT(message("target_color: super-red", "target_color: reddish"),
              testing::HasSubstr("'target_color' must be"));
  EXPECT_THAT(message("floor_camera:\n", "floor_camera:\n  exposure: target\n"), "")
      << "the head's camera does not read the other's section";
  EXPECT_THAT(Load(With("floor_camera:\n  source", "floor_camera:\n  exposure: target\n  source"),
                   Role::kFloor)
                  .message(),
              testing::HasSubstr("exposure"));
}

TEST(ColorCameraConfig, FlagsWin) {
  const auto config = Load(InstalledRobotFile(), Role::kHead, {"video:x.avi", "jpeg"});
  ASSERT_TRUE(config.ok()) << config.message();
  EXPECT_EQ(config->source.source, "video:x.avi");
  EXPECT_EQ(config->encoding, sensor::PixelFormat::kJpeg);
}

TEST(ColorCameraConfig, BadValuesAreRefusedByName) {
  std::string text = InstalledRobotFile();
  const std::string good = "power_line_hz: 50";
  text.replace(text.find(good), good.size(), "power_line_hz: 55");
  const auto config = Load(text, Role::kHead);
  ASSERT_FALSE(config.ok());
  EXPECT_NE(config.message().find("power_line_hz"), std::string::npos) << config.message();
}

}  // namespace
}  // namespace geon::color_camera
