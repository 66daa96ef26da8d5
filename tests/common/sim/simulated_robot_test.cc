#include "sim/simulated_robot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/angles.h"
#include "base/contracts.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

std::unique_ptr<SimulatedRobot> MakeRobot(uint64_t seed = 1) {
  SimOptions options;
  options.renderer = WithoutMountingErrors();
  auto robot = SimulatedRobot::Create(
      WorldFrom("  - {geon: cuboid, size_m: [0.2, 0.2, 0.2], x_m: 1.5, y_m: 2.0}\n"), TestRig(),
      options, seed);
  EXPECT_TRUE(robot.ok()) << robot.message();
  return std::move(*robot);
}

void Say(SimulatedRobot* robot, DeviceId device, const std::string& text) {
  const std::vector<uint8_t> bytes(text.begin(), text.end());
  robot->Receive(device, bytes);
}

std::string Hear(SimulatedRobot* robot, DeviceId device) {
  const std::vector<uint8_t> bytes = robot->Transmit(device);
  return {bytes.begin(), bytes.end()};
}

std::vector<Exposure> Of(CameraId camera, const std::vector<Exposure>& exposures) {
  std::vector<Exposure> some;
  std::copy_if(exposures.begin(), exposures.end(), std::back_inserter(some),
               [camera](const Exposure& exposure) { return exposure.camera == camera; });
  return some;
}

TEST(SimulatedRobotTest, CamerasRunAtTheirRatesWithoutGaps) {
  const auto robot = MakeRobot();
  robot->Advance(2.0);
  const auto exposures = robot->TakeExposures();
  EXPECT_TRUE(robot->TakeExposures().empty());
  EXPECT_EQ(Of(CameraId::kHeadColor, exposures).size(), 10u);
  EXPECT_EQ(Of(CameraId::kFloorColor, exposures).size(), 10u);
  const auto bw = Of(CameraId::kHeadBw, exposures);
  ASSERT_EQ(bw.size(), 60u);
  for (size_t k = 0; k < bw.size(); ++k) {
    EXPECT_EQ(bw[k].seq, static_cast<int64_t>(k + 1));
    EXPECT_NEAR(bw[k].end_s - bw[k].start_s, 0.010, 1e-9);
    if (k > 0) {
      EXPECT_NEAR(bw[k].start_s - bw[k - 1].start_s, 1.0 / 30.0, 0.001);
    }
  }
}

TEST(SimulatedRobotTest, ALaserSwitchedWithinAnExposureLightsPartOfIt) {
  // Whenever the command comes, exposures before it are dark, after it lit, and the one it falls
  // into has the share that remained.
  bool partial_seen = false;
  for (int shift_ms = 0; shift_ms < 30 && !partial_seen; ++shift_ms) {
    const auto robot = MakeRobot();
    robot->Advance(1.125 + 0.001 * shift_ms);
    Say(robot.get(), DeviceId::kLasers, "M71T1\n");
    robot->Advance(1.6);
    const auto bw = Of(CameraId::kHeadBw, robot->TakeExposures());
    double last_1 = 0.0;
    for (const Exposure& exposure : bw) {
      EXPECT_GE(exposure.lasers.horizontal_1, last_1);
      EXPECT_EQ(exposure.lasers.vertical_1, 0.0);
      last_1 = exposure.lasers.horizontal_1;
      partial_seen = partial_seen || (last_1 > 0.0 && last_1 < 1.0);
    }
    EXPECT_EQ(bw.front().lasers.horizontal_1, 0.0);
    EXPECT_EQ(last_1, 1.0);
    EXPECT_TRUE(robot->truth().horizontal_laser);
  }
  EXPECT_TRUE(partial_seen);
}

TEST(SimulatedRobotTest, ExposuresShowTheHeadWhereItReallyIs) {
  const auto robot = MakeRobot();
  robot->Advance(0.5);
  for (const Exposure& before : robot->TakeExposures())
    EXPECT_EQ(before.path.middle().pan_rad, 0.0);
  Say(robot.get(), DeviceId::kPtu, "PP1000 ");
  robot->Advance(3.0);
  const auto exposures = Of(CameraId::kHeadColor, robot->TakeExposures());
  const double final_rad = RadiansFromDegrees(1000 * 185.1428 / 3600);
  EXPECT_NEAR(exposures.back().path.middle().pan_rad, final_rad, 1e-9);
  EXPECT_TRUE(std::any_of(exposures.begin(), exposures.end(), [&](const Exposure& exposure) {
    const double pan_rad = exposure.path.middle().pan_rad;
    return pan_rad > 0.05 * final_rad && pan_rad < 0.95 * final_rad;
  }));
}

TEST(SimulatedRobotTest, AnExposureHasMorePosesThePictureMovesThrough) {
  const auto robot = MakeRobot();
  robot->Advance(0.5);
  for (const Exposure& still : robot->TakeExposures()) EXPECT_EQ(still.path.poses.size(), 1u);
  Say(robot.get(), DeviceId::kPtu, "PS400 PP1000 ");  // 20.6 degrees a second
  robot->Advance(1.5);
  const auto moving = Of(CameraId::kHeadBw, robot->TakeExposures());
  const RigPath& path = moving[moving.size() / 2].path;
  // 0.36 rad/s for 10 ms: 5.8 px of 1600.
  ASSERT_EQ(path.poses.size(), 4u);
  for (size_t k = 1; k < path.poses.size(); ++k) {
    EXPECT_NEAR(path.poses[k].pan_rad - path.poses[k - 1].pan_rad, 0.36 * 0.0025, 0.36 * 0.0006);
  }
}

TEST(SimulatedRobotTest, ALongerExposureIsBrighterAndTakesItsTime) {
  const auto robot = MakeRobot();
  robot->Advance(0.5);
  robot->TakeExposures();
  robot->SetExposure(CameraId::kHeadBw, 0.250);
  Say(robot.get(), DeviceId::kLasers, "M71T1\n");
  robot->Advance(2.0);
  auto bw = Of(CameraId::kHeadBw, robot->TakeExposures());
  ASSERT_GE(bw.size(), 6u);
  EXPECT_EQ(bw[0].exposure_1, 1.0) << "the next frame was asked for before";
  while (bw.front().exposure_1 == 1.0) bw.erase(bw.begin());
  ASSERT_GE(bw.size(), 4u);
  for (const Exposure& exposure : bw) {
    EXPECT_NEAR(exposure.end_s - exposure.start_s, 0.250, 1e-9);
    EXPECT_EQ(exposure.exposure_s, 0.250);
    EXPECT_DOUBLE_EQ(exposure.exposure_1, 25.0);
  }
  EXPECT_NEAR(bw[2].start_s - bw[1].start_s, 0.278, 0.0011);  // a tenth of it to read out
  EXPECT_EQ(bw[2].seq, bw[1].seq + 1);
  EXPECT_EQ(bw[2].lasers.horizontal_1, 1.0);
  robot->SetExposure(CameraId::kHeadBw, 0.010);
  robot->Advance(3.0);
  EXPECT_DOUBLE_EQ(robot->TakeExposures().back().exposure_1, 1.0);
}

TEST(SimulatedRobotTest, AnExposureNoCameraHasBecomesTheNearest) {
  const auto robot = MakeRobot();
  robot->SetExposure(CameraId::kHeadColor, 1e-9);
  robot->SetExposure(CameraId::kHeadBw, 1e9);
  robot->SetExposure(CameraId::kFloorColor, 0.0023);  // no whole number of steps
  robot->Advance(6.0);
  const auto exposures = robot->TakeExposures();
  EXPECT_EQ(Of(CameraId::kHeadColor, exposures).back().exposure_s, 0.0001);
  EXPECT_EQ(Of(CameraId::kHeadBw, exposures).back().exposure_s, 2.0);
  EXPECT_EQ(Of(CameraId::kFloorColor, exposures).back().exposure_s, 0.0023);
  EXPECT_DOUBLE_EQ(Of(CameraId::kFloorColor, exposures).back().exposure_1, 0.115);
  EXPECT_THROW(robot->SetExposure(CameraId::kHeadColor, 0.0), ContractViolation);
}

TEST(SimulatedRobotTest, StartsWhereTheWorldSays) {
  const auto robot = MakeRobot();
  robot->Advance(0.1);
  const RobotTruth truth = robot->truth();
  EXPECT_NEAR(truth.x_m, 1.5, 1e-12);
  EXPECT_NEAR(truth.y_m, 0.6, 1e-12);
  EXPECT_NEAR(truth.turret_rad, kPi / 2, 1e-12);
  EXPECT_EQ(truth.contacts, 0);
  EXPECT_NEAR(truth.time_s, 0.1, 1e-9);
}

TEST(SimulatedRobotTest, HowTimeIsCutDoesNotMatter) {
  const auto coarse = MakeRobot(3), fine = MakeRobot(3);
  std::string from_coarse, from_fine;
  for (const auto& robot : {coarse.get(), fine.get()}) {
    robot->Advance(0.2);
    Say(robot, DeviceId::kPtu, "PP500 A PP ");
    Say(robot, DeviceId::kLasers, "M71T2\n");
  }
  coarse->Advance(1.5);
  from_coarse = Hear(coarse.get(), DeviceId::kPtu);
  for (int k = 1; k <= 260; ++k) {
    fine->Advance(0.2 + 0.005 * k);
    from_fine += Hear(fine.get(), DeviceId::kPtu);
  }
  EXPECT_EQ(from_coarse, from_fine);
  const auto a = coarse->TakeExposures(), b = fine->TakeExposures();
  ASSERT_EQ(a.size(), b.size());
  RigRenderer first = coarse->MakeRenderer(), second = fine->MakeRenderer();
  EXPECT_EQ(Develop(a.back(), &first).pixels, Develop(b.back(), &second).pixels);
}

}  // namespace
}  // namespace geon::sim
