#include "procs/lockstep/robot_trial.h"

#include <gtest/gtest.h>

#include "config/daemon_arguments.h"
#include "sim/world_file.h"

namespace geon::lockstep {
namespace {

// Near enough to be scanned from where the robot starts: few pictures are rendered.
constexpr const char* kNearWorld = R"(
pen: {size_m: [3.0, 4.5], wall_height_m: 0.65}
floor: {color_rgb: [150, 150, 140]}
robot: {x_m: 1.5, y_m: 1.0, heading_deg: 90}
light: {kelvin: 4000, level: 1.0}
objects:
  - {box: [0.6, 0.6, 0.7], x_m: 1.5, y_m: 2.0, color_rgb: [90, 90, 120]}
  - {geon: cuboid, size_m: [0.14, 0.11, 0.18], position: 1, x_m: 1.5, y_m: 1.95, yaw_deg: 30,
     color_rgb: [150, 40, 40]}
)";

class RobotTrialTest : public testing::Test {
 protected:
  Result<RobotOutcome> RunTrial(const sim::World& world, double longest_s) const {
    const auto calibration =
        recognizer::LoadStripeCalibration(settings_->recognizer.calibration_dir, settings_->rig);
    return RunRobotTrial(*settings_, *calibration, world, 1, longest_s);
  }
  const Result<LockstepSettings> settings_ =
      LoadLockstepSettings(config::InstalledFile("scripts/config/robot.yaml"),
                           config::InstalledFile("scripts/config/sim.yaml"));
  const Result<sim::World> near_ = sim::ParseWorld(kNearWorld, "near.yaml", ".");
};

TEST_F(RobotTrialTest, AGeonIsNamedAndTheRunIsFilmed) {
  const auto outcome = RunTrial(*near_, 60.0);
  ASSERT_TRUE(outcome.ok()) << outcome.message();
  EXPECT_EQ(outcome->end, sensor::MissionOutcome::kNamed) << outcome->why;
  ASSERT_TRUE(outcome->verdict.has_value());
  EXPECT_EQ(outcome->verdict->label, GeonLabel::kCuboid);
  EXPECT_EQ(outcome->why, "the geon is a cuboid");
  EXPECT_EQ(outcome->track.contacts, 0);
  ASSERT_TRUE(outcome->track.first_sight_s.has_value());
  EXPECT_LT(*outcome->track.first_sight_s, outcome->end_s);
  ASSERT_TRUE(outcome->target_W_m.has_value());
  EXPECT_LT((*outcome->target_W_m - Eigen::Vector2d(1.5, 1.95)).norm(), 0.15);
  EXPECT_EQ(outcome->view.data.size(), 3U * 640U * 480U);
  EXPECT_EQ(outcome->mask.size(), 640U * 480U);

  const std::vector<FilmFrame>& film = outcome->film;
  ASSERT_GE(film.size(), 4U);
  ASSERT_LE(film.size(), kMostFilmFrames);
  EXPECT_EQ(film.front().phase, mission::Phase::kSearch);
  EXPECT_EQ(film[film.size() - 2].phase, mission::Phase::kScan);
  EXPECT_EQ(film.back().phase, mission::Phase::kDone);
  EXPECT_EQ(film.back().time_s, outcome->end_s);
  EXPECT_EQ(film.back().text, outcome->why);
  EXPECT_TRUE(film.back().image.data.empty()) << "nobody looked during the scan";
  int32_t seq = 0;
  for (const FilmFrame& frame : film) {
    EXPECT_NEAR(frame.place_W_m.x(), 1.5, 0.3);
    if (frame.image.data.empty()) continue;
    EXPECT_GT(frame.image.seq, seq);
    seq = frame.image.seq;
  }
  EXPECT_GT(seq, 0);
}

TEST_F(RobotTrialTest, WhenTimeIsOverTheMissionStillRuns) {
  const auto outcome = RunTrial(*near_, 0.3);
  ASSERT_TRUE(outcome.ok()) << outcome.message();
  EXPECT_EQ(outcome->end, sensor::MissionOutcome::kRunning);
  EXPECT_NEAR(outcome->end_s, 0.3, 1e-9);
  EXPECT_FALSE(outcome->verdict.has_value());
  EXPECT_FALSE(outcome->why.empty());
}

TEST_F(RobotTrialTest, AMeshThatIsNotThereIsAnError) {
  sim::World world = *near_;
  world.objects.back().shape = sim::MeshShape{"/no/such/mesh.obj", 0.2, GeonLabel::kCuboid};
  const auto outcome = RunTrial(world, 1.0);
  ASSERT_FALSE(outcome.ok());
  EXPECT_NE(outcome.message().find("/no/such/mesh.obj"), std::string::npos) << outcome.message();
}

}  // namespace
}  // namespace geon::lockstep
