#include "procs/recognizer/recognizer_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/procs/recognizer/board_scene.h"

namespace geon::recognizer {
namespace {

using testing::HasSubstr;

Status Read(const std::string& yaml, RecognizerConfig* config) {
  auto document = config::YamlDocument::Parse(yaml, "robot.yaml");
  ReadRecognizerSection(document->root().Child("recognizer"), config);
  return document->Finish();
}

TEST(RecognizerConfig, ReadsItsSection) {
  RecognizerConfig config;
  const Status status = Read(
      "recognizer:\n  calibration_dir: cal\n  method: thesis\n  curvature: ramer\n  smoothing: "
      "gaussian\n"
      "  fewest_points: 20\n",
      &config);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(config.calibration_dir, "cal");
  EXPECT_EQ(config.assembler.recognition.method, recognition::Method::kThesis);
  EXPECT_EQ(config.assembler.recognition.curvature, recognition::CurvatureMethod::kRamer);
  EXPECT_EQ(config.assembler.recognition.smoothing.kind, recognition::Smoothing::kGaussian);
  EXPECT_EQ(config.assembler.fewest_points, 20);
}

TEST(RecognizerConfig, RefusesUnknownNamesWithTheirLine) {
  RecognizerConfig config;
  const Status status = Read(
      "recognizer:\n  calibration_dir: cal\n  method: evidence\n  curvature: roemer\n  smoothing: "
      "median\n"
      "  fewest_points: 20\n",
      &config);
  EXPECT_THAT(status.message(), HasSubstr("robot.yaml:4"));
  EXPECT_THAT(status.message(), HasSubstr("ogorman, ramer or wall"));
}

TEST(RecognizerConfig, DistancesComeFromTheTablesUnlessTheFileSaysTheRig) {
  const std::string rest =
      "  calibration_dir: nowhere\n  method: thesis\n  curvature: ramer\n  smoothing: none\n"
      "  fewest_points: 20\n";
  RecognizerConfig config;
  ASSERT_TRUE(Read("recognizer:\n" + rest, &config).ok());
  EXPECT_EQ(config.ranging, Ranging::kLookUpTable);
  EXPECT_FALSE(LoadCalibration(config).ok());
  ASSERT_TRUE(Read("recognizer:\n  ranging: rig\n" + rest, &config).ok());
  EXPECT_EQ(config.ranging, Ranging::kRig);
  EXPECT_FALSE(LoadCalibration(config).value().has_value());
  EXPECT_THAT(Read("recognizer:\n  ranging: ruler\n" + rest, &config).message(),
              HasSubstr("lut or rig"));
}

TEST(RecognizerConfig, TheShippedRobotFileIsGoodAndItsCalibrationLiesBesideIt) {
  const RecognizerConfig config = TestConfig();
  EXPECT_EQ(config.calibration_dir,
            std::filesystem::path(GEON_SOURCE_DIR) / "scripts/config/calibration");
  EXPECT_GT(config.rig.stripe_camera.fx_px, 0.0);
  EXPECT_FALSE(CalibrationHash(config, std::nullopt).empty());
  EXPECT_EQ(CalibrationHash(config, TestCalibration(config.rig)), "0123456789abcdef");
}

TEST(RecognizerConfig, AFolderOnTheCommandLineWins) {
  const auto config = LoadRecognizerConfig(
      std::filesystem::path(GEON_SOURCE_DIR) / "scripts/config/robot.yaml", "/elsewhere");
  ASSERT_TRUE(config.ok()) << config.message();
  EXPECT_EQ(config->calibration_dir, "/elsewhere");
  EXPECT_EQ(config->ranging, Ranging::kLookUpTable);
}

}  // namespace
}  // namespace geon::recognizer
