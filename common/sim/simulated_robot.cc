#include "sim/simulated_robot.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/contracts.h"
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
  base.drive.grooves = {world.floor_tile_m, world.groove_tilt_rad};
  return base;
}

LineFaultOptions Seeded(LineFaultOptions faults, uint64_t seed, DeviceId device) {
  faults.seed = HashMix(seed, 100U + static_cast<uint64_t>(device));
  return faults;
}

int64_t Steps(double duration_s, double step_s) {
  return std::max<int64_t>(1, std::llround(duration_s / step_s));
}

// How far a picture moves between two poses, roughly: what is 1 m away.
double Shift(const RigPose& from, const RigPose& to, double focal_px) {
  const geometry::RigidTransform turned = from.X_WR.inverse() * to.X_WR;
  return focal_px * (std::abs(to.pan_rad - from.pan_rad) + std::abs(to.tilt_rad - from.tilt_rad) +
                     Eigen::AngleAxisd(turned.linear()).angle() + turned.translation().norm());
}

// So many poses of an exposure that the picture is smeared and not doubled; the same instants for
// any motion, and the middle one if there was none.
RigPath PathOf(const std::vector<RigPose>& poses, double focal_px) {
  constexpr double kStill_px = 1.5, kFast_px = 14.0;
  double shift_px = 0.0;
  for (size_t k = 1; k < poses.size(); ++k) shift_px += Shift(poses[k - 1], poses[k], focal_px);
  size_t count = SimulatedRobot::kMostPoses;
  if (shift_px < kFast_px) count /= 2;
  if (shift_px < kStill_px) count = 1;
  while (count > poses.size()) count /= 2;
  RigPath path;
  path.poses.clear();
  for (size_t k = 0; k < count; ++k) {
    path.poses.push_back(poses[(2 * k + 1) * poses.size() / (2 * count)]);
  }
  return path;
}

}  // namespace

Frame Develop(const Exposure& exposure, RigRenderer* renderer) {
  switch (exposure.camera) {
    case CameraId::kHeadColor:
      return renderer->HeadColor(exposure.path, exposure.seq, exposure.exposure_1);
    case CameraId::kHeadBw:
      return renderer->HeadBw(exposure.path, exposure.lasers, exposure.seq, exposure.exposure_1);
    case CameraId::kFloorColor:
      return renderer->FloorColor(exposure.path, exposure.seq, exposure.exposure_1);
  }
  throw ContractViolation("Develop: no such camera");
}

Result<std::unique_ptr<SimulatedRobot>> SimulatedRobot::Create(const World& world,
                                                               const geometry::SensorRig& rig,
                                                               const SimOptions& options,
                                                               uint64_t seed) {
  Result<std::shared_ptr<const Scene>> scene = BuildScene(world, options.geon_mesh);
  if (!scene.ok()) return scene.status();
  return std::unique_ptr<SimulatedRobot>(
      new SimulatedRobot(world, std::move(*scene), rig, options, seed));
}

SimulatedRobot::SimulatedRobot(const World& world, std::shared_ptr<const Scene> scene,
                               const geometry::SensorRig& rig, const SimOptions& options,
                               uint64_t seed)
    : scene_(std::move(scene)),
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
  const geometry::PinholeCamera* drawn[] = {&rig_.color_camera, &rig_.stripe_camera,
                                            &rig_.floor_camera};
  for (const CameraId camera : kCameras) {
    const auto k = static_cast<size_t>(camera);
    Shutter& shutter = shutters_[k];
    shutter.camera = camera;
    shutter.focal_px = drawn[k]->fx_px;
    shutter.made_period_steps = Steps(1.0 / cameras[k]->rate_hz, kStep_s);
    shutter.made_exposure_s = cameras[k]->exposure_us * 1e-6;
    shutter.dropped_1 = cameras[k]->dropped_1;
    shutter.asked_exposure_s = shutter.next_exposure_s = shutter.made_exposure_s;
    shutter.exposure_steps = Steps(shutter.made_exposure_s, kStep_s);
    // The cameras run freely: nothing makes them start together.
    shutter.next_start_step = static_cast<int64_t>(7 + 31 * k);
  }
}

void SimulatedRobot::SetExposure(CameraId camera, double exposure_s) {
  Require(exposure_s > 0.0, "SetExposure: exposure_s must be positive");
  constexpr double kLeast_s = 0.0001, kMost_s = 2.0;
  shutters_[static_cast<size_t>(camera)].asked_exposure_s =
      std::clamp(exposure_s, kLeast_s, kMost_s);
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
  Exposure& exposure = shutter->exposure;
  if (steps_ == shutter->next_start_step) {
    constexpr double kReadOut_1 = 0.1;  // of the period, at least
    const double exposure_s = std::exchange(shutter->next_exposure_s, shutter->asked_exposure_s);
    shutter->exposure_steps = Steps(exposure_s, kStep_s);
    const auto least_steps = static_cast<int64_t>(
        std::ceil(static_cast<double>(shutter->exposure_steps) / (1.0 - kReadOut_1)));
    shutter->next_start_step += std::max(shutter->made_period_steps, least_steps);
    shutter->start_step = steps_;
    exposure = Exposure();
    exposure.camera = shutter->camera;
    exposure.seq = ++shutter->seq;
    exposure.start_s = time_s();
    exposure.exposure_s = exposure_s;
    exposure.exposure_1 = exposure_s / shutter->made_exposure_s;
    shutter->poses.clear();
    shutter->lit_steps[0] = shutter->lit_steps[1] = 0;
  }
  if (shutter->seq == 0 || steps_ >= shutter->start_step + shutter->exposure_steps) return;
  for (size_t laser = 0; laser < 2; ++laser) {
    if (laser_board_.lasers()[laser]) ++shutter->lit_steps[laser];
  }
  shutter->poses.push_back(Pose());
  if (steps_ != shutter->start_step + shutter->exposure_steps - 1) return;
  const int32_t drop_key = 200 + static_cast<int32_t>(shutter->camera);
  if (HashUniform(seed_, drop_key, static_cast<int32_t>(shutter->seq)) < shutter->dropped_1) return;
  exposure.end_s = time_s() + kStep_s;
  const auto share_1 = [&](size_t laser) {
    return static_cast<double>(shutter->lit_steps[laser]) /
           static_cast<double>(shutter->exposure_steps);
  };
  exposure.lasers = {share_1(0), share_1(1)};
  exposure.path = PathOf(shutter->poses, shutter->focal_px);
  exposures_.push_back(exposure);
}

std::vector<Exposure> SimulatedRobot::TakeExposures() { return std::exchange(exposures_, {}); }

RigPose SimulatedRobot::Pose() const {
  const SynchroDrive& drive = base_.drive();
  RigPose pose;
  pose.X_WR =
      geometry::PlanarPose(drive.center_W_m().x(), drive.center_W_m().y(), drive.turret_W_rad());
  pose.X_WR.linear() = drive.tilt_W() * pose.X_WR.linear();
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
