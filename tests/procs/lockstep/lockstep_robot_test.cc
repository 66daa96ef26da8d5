#include "procs/lockstep/lockstep_robot.h"

#include <gtest/gtest.h>

#include "config/daemon_arguments.h"
#include "config/scan_set_json.h"
#include "sim/world_file.h"

namespace geon::lockstep {
namespace {

constexpr const char* kWorld = R"(
pen: {size_m: [3.0, 4.5], wall_height_m: 0.65}
floor: {color_rgb: [150, 150, 140]}
robot: {x_m: 1.5, y_m: 1.0, heading_deg: 90}
light: {kelvin: 4000, level: 1.0}
objects:
  - {box: [0.6, 0.6, 0.7], x_m: 1.5, y_m: 2.0, color_rgb: [90, 90, 120]}
  - {geon: cuboid, size_m: [0.14, 0.11, 0.18], position: 1, x_m: 1.5, y_m: 1.95, yaw_deg: 30,
     color_rgb: [150, 40, 40]}
)";

struct MissionRun {
  std::vector<mission::Phase> phases;
  double end_s = 0.0;
  std::optional<sensor::GeonVerdict> verdict;
  sensor::ScanSet scan;
  sim::RobotTruth truth;
};

MissionRun RunMission(uint64_t seed) {
  const auto settings = LoadLockstepSettings(config::InstalledFile("scripts/config/robot.yaml"),
                                             config::InstalledFile("scripts/config/sim.yaml"));
  EXPECT_TRUE(settings.ok()) << settings.message();
  const auto calibration =
      recognizer::LoadStripeCalibration(settings->recognizer.calibration_dir, settings->rig);
  EXPECT_TRUE(calibration.ok()) << calibration.message();
  const auto world = sim::ParseWorld(kWorld, "world.yaml", ".");
  EXPECT_TRUE(world.ok()) << world.message();
  const auto robot = LockstepRobot::Create(*settings, *calibration, *world, seed).value();
  MissionRun run;
  while (robot->mission().outcome() == sensor::MissionOutcome::kRunning && robot->time_s() < 60.0) {
    robot->Turn();
    const mission::Phase phase = robot->mission().phase();
    if (run.phases.empty() || run.phases.back() != phase) run.phases.push_back(phase);
  }
  run.end_s = robot->time_s();
  run.verdict = robot->mission().verdict();
  run.scan = robot->scan();
  run.truth = robot->truth();
  return run;
}

TEST(LockstepRobotTest, NamesAGeonOnABox) {
  const MissionRun run = RunMission(1);
  ASSERT_GE(run.phases.size(), 2U);
  EXPECT_EQ(run.phases[run.phases.size() - 2], mission::Phase::kScan);
  EXPECT_EQ(run.phases.back(), mission::Phase::kDone);
  ASSERT_TRUE(run.verdict.has_value());
  EXPECT_EQ(run.verdict->label, GeonLabel::kCuboid);
  EXPECT_EQ(run.scan.profiles.size(), 6U);
  EXPECT_EQ(run.truth.contacts, 0);
}

TEST(LockstepRobotTest, TheSameSeedGivesTheSameMissionAndAnotherSeedOtherNoise) {
  const MissionRun run = RunMission(2);
  const MissionRun again = RunMission(2);
  EXPECT_EQ(run.end_s, again.end_s);
  EXPECT_EQ(config::SerializeScanSet(run.scan), config::SerializeScanSet(again.scan));
  EXPECT_NE(config::SerializeScanSet(run.scan), config::SerializeScanSet(RunMission(3).scan));
}

}  // namespace
}  // namespace geon::lockstep
