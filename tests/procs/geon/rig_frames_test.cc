#include "procs/geon/rig_frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "config/daemon_arguments.h"
#include "config/rig_config.h"
#include "config/text_file.h"
#include "procs/geon/image_file.h"
#include "procs/geon/simulated_rig_frames.h"

namespace geon::cli {
namespace {

using testing::HasSubstr;
using Light = RigFrame::Light;

geometry::SensorRig DrawnRigOfRobotFile() {
  const auto robot =
      config::LoadRobotFile(config::InstalledFile("scripts/config/robot.yaml"), {"rig"});
  return config::ReadDrawnRig(robot->root().Child("rig"));
}

class RigFramesTest : public testing::Test {
 protected:
  void SetUp() override {
    dir_ =
        std::filesystem::temp_directory_path() / ("geon_rig_frames_" + std::to_string(::getpid()));
    std::filesystem::create_directories(dir_);
  }
  void TearDown() override { std::filesystem::remove_all(dir_); }

  std::string Error(const std::string& lines) {
    const std::string heading = "stop,pan_deg,tilt_deg,camera,laser,exposure_s,file\n";
    EXPECT_TRUE(config::WriteFileAtomically(dir_ / "frames.csv", heading + lines).ok());
    return RecordedRig(dir_).message();
  }
  std::filesystem::path dir_;
};

TEST_F(RigFramesTest, LinesOfOneHeadPoseAreOneShot) {
  ASSERT_TRUE(SaveGrayPng(dir_ / "a.png", std::vector<uint8_t>(48, 7), 8, 6).ok());
  EXPECT_EQ(Error("0,1.5,-2,stripe,none,0.25,a.png\n"
                  "0,1.5,-2,stripe,vertical,0.01,a.png\n"
                  "floor,0,-40,stripe,horizontal,0.01,a.png\n"),
            "");
  const auto series = RecordedRig(dir_);
  ASSERT_EQ(series->shots, 2);
  const auto shot = series->at(0);
  ASSERT_TRUE(shot.ok()) << shot.message();
  ASSERT_EQ(shot->frames.size(), 2U);
  EXPECT_EQ(shot->frames[1].light, Light::kVertical);
  EXPECT_EQ(shot->frames[0].exposure_s, 0.25);
  EXPECT_EQ(shot->frames[0].image.width_px, 8);
  EXPECT_EQ(series->at(1)->stop, RigShot::kFloor);
}

TEST_F(RigFramesTest, BadListingsAreRefusedWithTheirLine) {
  EXPECT_THAT(Error("0,0,0,stripe,none,0.1\n"), HasSubstr("frames.csv:2: must have 7 fields"));
  EXPECT_THAT(Error("x,0,0,stripe,none,0.1,a.png\n"), HasSubstr("stop must be"));
  EXPECT_THAT(Error("0,much,0,stripe,none,0.1,a.png\n"), HasSubstr("must be degrees"));
  EXPECT_THAT(Error("0,0,0,third,none,0.1,a.png\n"), HasSubstr("camera must be color or stripe"));
  EXPECT_THAT(Error("0,0,0,stripe,both,0.1,a.png\n"), HasSubstr("laser must be"));
  EXPECT_THAT(Error("0,0,0,stripe,none,-1,a.png\n"), HasSubstr("exposure_s"));
  EXPECT_THAT(Error(""), HasSubstr("lists no frames"));
  ASSERT_TRUE(config::WriteFileAtomically(dir_ / "frames.csv", "a,b\n").ok());
  EXPECT_THAT(RecordedRig(dir_).message(), HasSubstr("the header must be"));
}

TEST_F(RigFramesTest, PicturesOfAnotherSizeAreRefused) {
  ASSERT_TRUE(SaveGrayPng(dir_ / "a.png", std::vector<uint8_t>(48, 7), 8, 6).ok());
  EXPECT_EQ(Error("0,1.5,-2,stripe,none,0.25,a.png\n"), "");
  const auto shot = RecordedRig(dir_)->at(0);
  calibration::RigObservations observations;
  EXPECT_THAT(ObserveShot(*shot, DrawnRigOfRobotFile(), &observations).message(),
              HasSubstr("a.png: is 8 x 6, the drawing's stripe camera takes 640 x 480"));
}

// Of the simulated robot: saved and read back it shows the same; with the lasers' names exchanged
// it is refused.
TEST_F(RigFramesTest, ASimulatedShotComesBackFromItsFolder) {
  const geometry::SensorRig drawn = DrawnRigOfRobotFile();
  // Of three tilts one at least lays the stripe across white squares, not along their edges.
  calibration::RigObservations live;
  const RigSeries series = SimulatedRig(drawn, {}, live.board, {1, 1, 3, 0.25}, 1);
  Result<RigShot> shot = series.at(0);
  for (int k = 0; k < 3; ++k) {
    shot = series.at(k);
    ASSERT_TRUE(shot.ok());
    live.views.clear();
    ASSERT_TRUE(ObserveShot(*shot, drawn, &live).ok());
    ASSERT_EQ(live.views.size(), 1U);
    if (live.views[0].horizontal_px.size() > 30U) break;
  }
  EXPECT_EQ(live.views[0].stripe_corners_px.size(), 70U);
  EXPECT_EQ(live.views[0].color_corners_px.size(), 70U);
  EXPECT_GT(live.views[0].horizontal_px.size(), 30U);
  EXPECT_GT(live.views[0].vertical_px.size(), 20U);

  Result<RigRecorder> recorder = RigRecorder::Create(dir_ / "saved");
  ASSERT_TRUE(recorder.ok());
  ASSERT_TRUE(recorder->Add(*shot).ok());
  ASSERT_TRUE(recorder->Finish().ok());
  const auto recorded = RecordedRig(dir_ / "saved");
  ASSERT_TRUE(recorded.ok()) << recorded.message();
  calibration::RigObservations again;
  ASSERT_TRUE(ObserveShot(*recorded->at(0), drawn, &again).ok());
  EXPECT_EQ(again.views[0].stripe_corners_px, live.views[0].stripe_corners_px);
  EXPECT_EQ(again.views[0].horizontal_px, live.views[0].horizontal_px);
  EXPECT_NEAR(again.views[0].tilt_rad, live.views[0].tilt_rad, 1e-8);

  RigShot swapped = *shot;
  for (RigFrame& frame : swapped.frames) {
    if (frame.light == Light::kNone) continue;
    frame.light = frame.light == Light::kVertical ? Light::kHorizontal : Light::kVertical;
  }
  EXPECT_THAT(ObserveShot(swapped, drawn, &again).message(), HasSubstr("the lasers are swapped"));
}

}  // namespace
}  // namespace geon::cli
