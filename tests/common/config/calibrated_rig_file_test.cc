#include "config/calibrated_rig_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/angles.h"
#include "config/daemon_arguments.h"
#include "config/rig_config.h"
#include "config/text_file.h"

namespace geon::config {
namespace {

using geometry::CalibratedRig;
using testing::AllOf;
using testing::HasSubstr;

geometry::SensorRig InstalledDrawing() {
  const Result<YamlDocument> document =
      LoadRobotFile(std::filesystem::path(GEON_SOURCE_DIR) / "scripts/config/robot.yaml", {"rig"});
  return ReadDrawnRig(document->root().Child("rig"));
}

// A rig with every number its own.
CalibratedRig Calibrated() {
  CalibratedRig calibrated;
  calibrated.rig = InstalledDrawing();
  geometry::SensorRig& rig = calibrated.rig;
  rig.stripe_camera.fx_px = rig.stripe_camera.fy_px = 1612.3456789012345;
  rig.stripe_camera.cx_px = 320.25;
  rig.stripe_camera.k1_1 = -0.091;
  rig.color_camera.k2_1 = 0.3;
  rig.ptu_axes = {0.0017453292519943296, 0.0, {0.0015, 0.0, 0.0}};
  rig.X_TB.linear() = rig.X_TB.linear() * geometry::RotationAboutX(0.01);
  rig.X_TC.translation().x() += 0.0012;
  rig.X_RP.translation().z() += 0.004;
  rig.horizontal_laser.normal_T =
      (geometry::RotationAboutY(0.005) * rig.horizontal_laser.normal_T).normalized();
  calibrated.date = "2026-11-22";
  calibrated.stops = 5;
  calibrated.views = 75;
  calibrated.residuals = {{"corners in the B/W pictures", 5250, 0.0412, 3}};
  calibrated.range_sigmas = {{"horizontal", 1.0, 0.00023}};
  calibrated.estimates = {{"B/W camera", "focal length", "px", 12.3, 0.2, false},
                          {"B/W camera", "distortion k2", "", 0.1, 0.8, true}};
  return calibrated;
}

std::string Refusal(const std::string& text) {
  const Result<CalibratedRig> parsed = ParseCalibratedRig(text, "rig.yaml", InstalledDrawing());
  return parsed.ok() ? "accepted" : parsed.message();
}

// With the hash that belongs to it.
std::string Rehashed(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  text.resize(text.rfind("fnv1a: "));
  return text + "fnv1a: \"" + ContentHash(text) + "\"\n";
}

TEST(CalibratedRigFile, ComesBackBitForBit) {
  const CalibratedRig written = Calibrated();
  const std::string text = SerializeCalibratedRig(written);
  const Result<CalibratedRig> read = ParseCalibratedRig(text, "rig.yaml", InstalledDrawing());
  ASSERT_TRUE(read.ok()) << read.message();
  EXPECT_EQ(SerializeCalibratedRig(*read), text);
  EXPECT_EQ(read->rig.stripe_camera.fx_px, written.rig.stripe_camera.fx_px);
  EXPECT_EQ(read->rig.X_TB.matrix(), written.rig.X_TB.matrix());
  EXPECT_EQ(read->rig.horizontal_laser.normal_T, written.rig.horizontal_laser.normal_T);
  EXPECT_NEAR(read->rig.ptu_axes.tilt_roll_rad, written.rig.ptu_axes.tilt_roll_rad, 1e-15);
  EXPECT_EQ(read->date, "2026-11-22");
  EXPECT_TRUE(read->estimates[1].weak);
  EXPECT_EQ(read->rig.floor_camera.width_px, 320);
}

TEST(CalibratedRigFile, AChangedOrCutFileIsRefused) {
  const std::string text = SerializeCalibratedRig(Calibrated());
  std::string changed = text;
  changed[changed.find("1612.3")] = '2';
  EXPECT_THAT(Refusal(changed), HasSubstr("changed by hand or damaged"));
  EXPECT_THAT(Refusal(text.substr(0, text.size() / 2)), HasSubstr("does not end in its hash"));
  EXPECT_THAT(Refusal(""), HasSubstr("does not end in its hash"));
}

TEST(CalibratedRigFile, EveryNumberIsChecked) {
  const std::string text = SerializeCalibratedRig(Calibrated());
  EXPECT_THAT(Refusal(Rehashed(text, "geon.rig.v1", "geon.rig.v9")),
              HasSubstr("must be geon.rig.v1"));
  EXPECT_THAT(Refusal(Rehashed(text, "width_px: 640", "width_px: 0")),
              HasSubstr("must be 16..8192"));
  EXPECT_THAT(Refusal(Rehashed(text, "k1_1: -0.091", "k1_1: .nan")), HasSubstr("'k1_1'"));
  EXPECT_THAT(Refusal(Rehashed(text, "normal_T: [", "normal_T: [1, ")), HasSubstr("normal_T"));
  EXPECT_THAT(Refusal(Rehashed(text, "rotation_TC: [0", "rotation_TC: [0.1")),
              HasSubstr("rotation matrix"));
  EXPECT_THAT(Refusal(Rehashed(text, "date: \"2026", "date: \"\\\"20")),
              HasSubstr("one line without"));
  EXPECT_THAT(Refusal(Rehashed(text, "stops: 5", "stops: 5\nextra: 1")), HasSubstr("'extra'"));
}

TEST(CalibratedRigFile, AnotherRobotsCalibrationIsNotBelieved) {
  const geometry::SensorRig drawn = InstalledDrawing();
  EXPECT_TRUE(CheckAgainstDrawing(Calibrated().rig, drawn).ok());
  geometry::SensorRig rig = Calibrated().rig;
  rig.stripe_camera.width_px = 1280;
  EXPECT_THAT(CheckAgainstDrawing(rig, drawn).message(), HasSubstr("pictures of 1280 x 480"));
  rig = Calibrated().rig;
  rig.vertical_laser.p_TLaser_m.y() -= 0.25;
  EXPECT_THAT(CheckAgainstDrawing(rig, drawn).message(), HasSubstr("the vertical laser is"));
  rig = Calibrated().rig;
  rig.X_TC.linear() = rig.X_TC.linear() * geometry::RotationAboutY(0.1);
  EXPECT_THAT(CheckAgainstDrawing(rig, drawn).message(),
              HasSubstr("the colour camera is 5.73 degrees"));
}

// A robot file that names a calibration beside it.
TEST(CalibratedRigFile, TheRobotFileNamesTheRigToWorkWith) {
  const auto dir = std::filesystem::temp_directory_path() /
                   ("geon_calibrated_rig_" + std::to_string(::getpid()));
  std::filesystem::create_directories(dir);
  std::string robot =
      *ReadFile(std::filesystem::path(GEON_SOURCE_DIR) / "scripts/config/robot.yaml");
  const std::string shipped = "calibration/rig.yaml";
  robot.replace(robot.find(shipped), shipped.size(), "rig.yaml");
  ASSERT_TRUE(WriteFileAtomically(dir / "robot.yaml", robot).ok());
  const auto load = [&] {
    const Result<YamlDocument> document = LoadRobotFile(dir / "robot.yaml", {"rig"});
    const RobotRig rig = ReadRobotRig(document->root().Child("rig"), dir / "robot.yaml");
    return std::pair(rig, document->Finish());
  };
  EXPECT_THAT(load().second.message(),
              AllOf(HasSubstr("cannot open"), HasSubstr("geon calibrate rig")));
  ASSERT_TRUE(WriteFileAtomically(dir / "rig.yaml", SerializeCalibratedRig(Calibrated())).ok());
  const auto [rig, status] = load();
  EXPECT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(rig.rig.stripe_camera.fx_px, Calibrated().rig.stripe_camera.fx_px);
  EXPECT_THAT(rig.source, HasSubstr("calibrated 2026-11-22"));
  CalibratedRig other = Calibrated();
  other.rig.stripe_camera.fx_px = 2000.0;
  ASSERT_TRUE(WriteFileAtomically(dir / "rig.yaml", SerializeCalibratedRig(other)).ok());
  EXPECT_THAT(load().second.message(), HasSubstr("focal length is 25 %"));
  std::filesystem::remove_all(dir);
}

}  // namespace
}  // namespace geon::config
