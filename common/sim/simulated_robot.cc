#include "sim/simulated_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/contracts.h"
#include "sim/groove_tilt.h"
#include "sim/hash_noise.h"
#include "sim/world_scene.h"

namespace geon::sim {
namespace {

NomadEmulatorOptions PlacedBase(const World& world, NomadEmulatorOptions base, uint64_t seed) {
  base.seed = HashMix(seed, 1);
  base.drive.x_m = world.robot_x_m;
  base.drive.y_m = world.robot_y_m;
  base.drive.heading_rad = world.robot_heading_rad;
  base.drive.radius_m = kRobotRadius_m;
  return base;
}

LineFaultOptions Seeded(LineFaultOptions faults, uint64_t seed, DeviceId device) {
  faults.seed = HashMix(seed, 100U + static_cast<uint64_t>(device));
  return faults;
}

int64_t Steps(double duration_s, double step_s) {
  return std::max<int64_t>(1, std::llround(duration_s / step_s));
}

}  // namespace

Frame Develop(const Exposure& exposure, RigRenderer* renderer) {
  switch (exposure.camera) {
    case CameraId::kHeadColor:
      return renderer->HeadColor(exposure.pose, exposure.seq);
    case CameraId::kHeadBw:
      return renderer->HeadBw(exposure.pose, exposure.lasers, exposure.seq);
    case CameraId::kFloorColor:
      return renderer->FloorColor(exposure.pose, exposure.seq);
  }
  throw ContractViolation("Develop: no such camera");
}

Result<std::unique_ptr<SimulatedRobot>> SimulatedRobot::Create(const World& world,
                                                               const geometry::SensorRig& rig,
                                                               const SimOptions& options,
                                                               uint64_t seed) {
  Result<std::shared_ptr<const Scene>> scene = BuildScene(world);
  if (!scene.ok()) return scene.status();
  return std::unique_ptr<SimulatedRobot>(
      new SimulatedRobot(world, std::move(*scene), rig, options, seed));
}

SimulatedRobot::SimulatedRobot(const World& world, std::shared_ptr<const Scene> scene,
                               const geometry::SensorRig& rig, const SimOptions& options,
                               uint64_t seed)
    : world_(world),
      scene_(std::move(scene)),
      rig_(rig),
      options_(options),
      seed_(seed),
      ptu_(options.ptu),
      laser_board_(options.lasers),
      base_(PlacedBase(world, options.base, seed), scene_.get()),
      lines_{
          Line{&ptu_, LineFaults(Seeded(options.ptu_faults, seed, DeviceId::kPtu))},
          Line{&base_, LineFaults(Seeded(options.base_faults, seed, DeviceId::kBase))},
          Line{&laser_board_, LineFaults(Seeded(options.laser_faults, seed, DeviceId::kLasers))}} {
  const CameraOptions* cameras[] = {&options_.renderer.color, &options_.renderer.stripe,
                                    &options_.renderer.floor};
  for (const CameraId camera : kCameras) {
    const auto k = static_cast<size_t>(camera);
    Shutter& shutter = shutters_[k];
    shutter.camera = camera;
    shutter.period_steps = Steps(1.0 / cameras[k]->rate_hz, kStep_s);
    shutter.exposure_steps = Steps(cameras[k]->exposure_us * 1e-6, kStep_s);
    // The cameras run freely: nothing makes them start together.
    shutter.phase_steps = static_cast<int64_t>(7 + 31 * k);
  }
}

void SimulatedRobot::Receive(DeviceId device, std::span<const uint8_t> bytes) {
  if (bytes.empty()) return;
  line(device).device->Receive(line(device).faults.ToDevice(bytes), time_s());
}

void SimulatedRobot::PortOpened(DeviceId device) { line(device).device->PortOpened(time_s()); }

std::vector<uint8_t> SimulatedRobot::Transmit(DeviceId device) {
  Line& wire = line(device);
  return wire.faults.ToHost(wire.device->Transmit(time_s()), time_s());
}

void SimulatedRobot::Advance(double until_s) {
  const auto until_steps = static_cast<int64_t>(std::floor(until_s / kStep_s + 1e-6));
  while (steps_ < until_steps) Step();
}

void SimulatedRobot::Step() {
  ++steps_;
  for (Line& wire : lines_) {
    if (wire.faults.TakeReboot(time_s())) wire.device->PowerCycle(time_s());
    wire.device->Advance(time_s());
  }
  for (Shutter& shutter : shutters_) StepShutter(&shutter);
}

void SimulatedRobot::StepShutter(Shutter* shutter) {
  const int64_t since_phase = steps_ - shutter->phase_steps;
  if (since_phase < 0) return;
  const int64_t into = since_phase % shutter->period_steps;
  Exposure& exposure = shutter->exposure;
  if (into == 0) {
    exposure = Exposure();
    exposure.camera = shutter->camera;
    exposure.seq = since_phase / shutter->period_steps + 1;
    exposure.start_s = time_s();
    shutter->lit_steps[0] = shutter->lit_steps[1] = 0;
  }
  if (into >= shutter->exposure_steps) return;
  for (size_t laser = 0; laser < 2; ++laser) {
    if (laser_board_.lasers()[laser]) ++shutter->lit_steps[laser];
  }
  if (into == shutter->exposure_steps / 2) exposure.pose = Pose();
  if (into != shutter->exposure_steps - 1) return;
  exposure.end_s = time_s() + kStep_s;
  const auto share_1 = [&](size_t laser) {
    return static_cast<double>(shutter->lit_steps[laser]) /
           static_cast<double>(shutter->exposure_steps);
  };
  exposure.lasers = {share_1(0), share_1(1)};
  exposures_.push_back(exposure);
}

std::vector<Exposure> SimulatedRobot::TakeExposures() { return std::exchange(exposures_, {}); }

RigPose SimulatedRobot::Pose() const {
  const SynchroDrive& drive = base_.drive();
  RigPose pose;
  pose.X_WR =
      geometry::PlanarPose(drive.center_W_m().x(), drive.center_W_m().y(), drive.turret_W_rad());
  pose.X_WR.linear() =
      GrooveTilt(world_, drive.center_W_m(), drive.base_W_rad()) * pose.X_WR.linear();
  pose.pan_rad = ptu_.pan_rad();
  pose.tilt_rad = ptu_.tilt_rad();
  return pose;
}

int SimulatedRobot::baud(DeviceId device) const {
  return lines_[static_cast<size_t>(device)].device->baud();
}

RobotTruth SimulatedRobot::truth() const {
  const SynchroDrive& drive = base_.drive();
  RobotTruth truth;
  truth.time_s = time_s();
  truth.x_m = drive.center_W_m().x();
  truth.y_m = drive.center_W_m().y();
  truth.heading_rad = drive.heading_W_rad();
  truth.turret_rad = drive.turret_W_rad();
  truth.speed_m_s = drive.true_speed_m_s();
  truth.turn_rate_rad_s = drive.true_turn_rate_rad_s();
  truth.pan_rad = ptu_.pan_rad();
  truth.tilt_rad = ptu_.tilt_rad();
  truth.horizontal_laser = laser_board_.lasers()[0];
  truth.vertical_laser = laser_board_.lasers()[1];
  constexpr double kTouch_m = 0.001;
  truth.contacts = static_cast<int>(
      std::count_if(drive.contacts().begin(), drive.contacts().end(),
                    [](const DiscContact& contact) { return contact.clearance_m < kTouch_m; }));
  truth.bumper = base_.bumper_pressed();
  return truth;
}

RigRenderer SimulatedRobot::MakeRenderer() const {
  return RigRenderer(scene_, rig_, options_.renderer, HashMix(seed_, 2));
}

}  // namespace geon::sim
