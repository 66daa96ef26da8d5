#include "sim/simulated_robot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/angles.h"
#include "base/contracts.h"
#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

std::unique_ptr<SimulatedRobot> MakeRobot(uint64_t seed = 1, double dropped_1 = 0.0) {
  SimOptions options;
  options.renderer = WithoutMountingErrors();
  options.renderer.stripe.dropped_1 = dropped_1;
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

TEST(SimulatedRobotTest, DroppedFramesNeverArriveAndAreTheSameForTheSameSeed) {
  constexpr double kDropped_1 = 0.2;
  const auto whole = MakeRobot(1), leaky = MakeRobot(1, kDropped_1),
             again = MakeRobot(1, kDropped_1);
  whole->Advance(20.0);
  leaky->Advance(20.0);
  for (int k = 1; k <= 200; ++k) again->Advance(0.1 * k);
  const auto all = whole->TakeExposures(), some = leaky->TakeExposures();
  EXPECT_EQ(Of(CameraId::kHeadColor, some).size(), 100u) << "the other cameras lose none";
  const auto bw = Of(CameraId::kHeadBw, some), same = Of(CameraId::kHeadBw, again->TakeExposures());
  EXPECT_NEAR(static_cast<double>(bw.size()), (1.0 - kDropped_1) * 600.0, 30.0);
  ASSERT_EQ(bw.size(), same.size());
  const auto complete = Of(CameraId::kHeadBw, all);
  for (size_t k = 0; k < bw.size(); ++k) {
    EXPECT_EQ(bw[k].seq, same[k].seq);
    // Those that arrive keep their number and their time.
    EXPECT_EQ(bw[k].start_s, complete.at(static_cast<size_t>(bw[k].seq - 1)).start_s);
  }
  const auto other = MakeRobot(2, kDropped_1);
  other->Advance(20.0);
  const auto of_other = Of(CameraId::kHeadBw, other->TakeExposures());
  EXPECT_FALSE(std::equal(bw.begin(), bw.end(), of_other.begin(), of_other.end(),
                          [](const auto& a, const auto& b) { return a.seq == b.seq; }));
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

// A robot at (0.9, 1.01) that looks along y; its foremost wheel stands in the groove at y = 1.2.
class TiltedRobotTest : public ::testing::TestWithParam<double> {
 protected:
  static constexpr double kY_m = 1.01;
  double tilt_rad() const { return RadiansFromDegrees(GetParam()); }

  std::unique_ptr<SimulatedRobot> Robot(const std::string& objects) const {
    World world = WorldFrom(objects);
    world.groove_tilt_rad = tilt_rad();
    world.robot_x_m = 0.9;
    world.robot_y_m = kY_m;
    SimOptions options;
    options.renderer = WithoutMountingErrors();
    return std::move(*SimulatedRobot::Create(world, TestRig(), options, 1));
  }
  // Of a point of the head that is `up_m` above the middle of its axes and 0.05 m ahead of it.
  struct HeadPoint {
    double ahead_m, height_m, pitch_rad;
  };
  HeadPoint Place(double up_m) const {
    const double pitch_rad = RadiansFromDegrees(15.0);  // as drawn, on a level floor
    const double ahead_m = 0.05 * std::cos(pitch_rad) + up_m * std::sin(pitch_rad);
    const double height_m = 1.2 - 0.05 * std::sin(pitch_rad) + up_m * std::cos(pitch_rad);
    // Nose down, about the middle of the wheels.
    return {ahead_m * std::cos(tilt_rad()) + height_m * std::sin(tilt_rad()),
            height_m * std::cos(tilt_rad()) - ahead_m * std::sin(tilt_rad()),
            pitch_rad + tilt_rad()};
  }
};

TEST_P(TiltedRobotTest, TheFarWallsRimMovesInThePictureAsGeometrySays) {
  const auto robot = Robot("");
  robot->Advance(0.3);
  const auto exposures = Of(CameraId::kHeadColor, robot->TakeExposures());
  ASSERT_FALSE(exposures.empty());
  RigRenderer renderer = robot->MakeRenderer();
  const Frame frame = Develop(exposures.front(), &renderer);
  const HeadPoint eye = Place(0.110);
  const geometry::PinholeCamera& camera = TestRig().color_camera;
  // Seen from above, the rim ends where the board's back is.
  const double below_rad = std::atan2(eye.height_m - 0.65, 4.52 - kY_m - eye.ahead_m);
  const double expected_px = camera.cy_px + camera.fy_px * std::tan(below_rad - eye.pitch_rad);
  ASSERT_GT(expected_px, 10.0);
  // The white board is brighter than what is behind it.
  const auto level = [&](int v) {
    return frame.pixels[static_cast<size_t>(3 * (v * frame.width_px + frame.width_px / 2))];
  };
  const int between = (level(2) + level(static_cast<int>(expected_px) + 40)) / 2;
  int v = 0;
  while (v < frame.height_px && level(v) < between) ++v;
  EXPECT_NEAR(v - 0.5, expected_px, 1.0);
}

TEST_P(TiltedRobotTest, AStripeMovesInThePictureAsGeometrySays) {
  const double front_m = 1.4;  // a box as high as the head, so far ahead of the robot's middle
  const auto robot = Robot(
      "  - {box: [1.0, 0.4, 1.4], x_m: 0.9, y_m: " + std::to_string(kY_m + front_m + 0.2) + "}\n");
  robot->Advance(1.2);
  const auto dark = Of(CameraId::kHeadBw, robot->TakeExposures()).back();
  Say(robot.get(), DeviceId::kLasers, "M71T1\n");
  robot->Advance(1.6);
  const auto bright = Of(CameraId::kHeadBw, robot->TakeExposures()).back();
  ASSERT_EQ(bright.lasers.horizontal_1, 1.0);
  RigRenderer renderer = robot->MakeRenderer();
  const Frame unlit = Develop(dark, &renderer), lit = Develop(bright, &renderer);
  double moment = 0.0, sum = 0.0;
  for (int v = 0; v < lit.height_px; ++v) {
    for (int u = lit.width_px / 2 - 20; u < lit.width_px / 2 + 20; ++u) {
      const auto k = static_cast<size_t>(v * lit.width_px + u);
      const int light = lit.pixels[k] - unlit.pixels[k];
      if (light < 20) continue;
      sum += light;
      moment += light * v;
    }
  }
  ASSERT_GT(sum, 0.0);
  // The fan starts 0.125 m above the B/W camera and crosses its axis at 1.037 m: a point at the
  // depth z is y = 0.125 (1 - z / 1.037) above the axis, and on the box's front.
  const HeadPoint eye = Place(0.045);
  const double c = std::cos(eye.pitch_rad), s = std::sin(eye.pitch_rad);
  const double z_m = (front_m - eye.ahead_m - 0.125 * s) / (c - 0.125 / 1.037 * s);
  const double y_m = 0.125 * (1.0 - z_m / 1.037);
  const geometry::PinholeCamera& camera = TestRig().stripe_camera;
  EXPECT_NEAR(moment / sum, camera.cy_px - camera.fy_px * y_m / z_m, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Tilts_deg, TiltedRobotTest, ::testing::Values(0.0, 0.5, 1.0, 2.0));

}  // namespace
}  // namespace geon::sim
