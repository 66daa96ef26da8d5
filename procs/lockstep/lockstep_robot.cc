#include "procs/lockstep/lockstep_robot.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "base/time.h"
#include "procs/lockstep/frame_image.h"
#include "procs/ptu/ptu_node.h"

namespace geon::lockstep {
namespace {

using sim::DeviceId;

constexpr int64_t kStart_utime = 1'000'000'000'000'000;  // any day; ids of scans count from it
// As the daemons do, in turns.
constexpr int64_t kPlannerTurns = 10;     // 20 Hz
constexpr int64_t kLaserStateTurns = 20;  // 10 Hz
constexpr int64_t kUnreadyTurns = 20;     // 10 Hz

sensor::Image Stamped(const sim::Exposure& exposure, sensor::Image image) {
  image.seq = static_cast<int32_t>(exposure.seq);
  image.utime = kStart_utime + MicrosecondsFromSeconds(exposure.start_s);
  image.exposure_s = exposure.exposure_s;
  return image;
}

sensor::Image Taken(const sim::Exposure& exposure, sim::RigRenderer* renderer) {
  return Stamped(exposure, ImageOf(sim::Develop(exposure, renderer)));
}

}  // namespace

Result<std::unique_ptr<LockstepRobot>> LockstepRobot::Create(
    const LockstepSettings& settings,
    const std::optional<recognizer::StripeCalibration>& calibration, const sim::World& world,
    uint64_t seed) {
  sim::World polished = world;
  polished.floor_gloss_1 = std::max(world.floor_gloss_1, settings.least_floor_gloss_1);
  auto simulated = sim::SimulatedRobot::Create(polished, settings.drawn_rig, settings.sim, seed);
  if (!simulated.ok()) return simulated.status();
  return std::unique_ptr<LockstepRobot>(
      new LockstepRobot(settings, calibration, std::move(*simulated)));
}

LockstepRobot::LockstepRobot(const LockstepSettings& settings,
                             const std::optional<recognizer::StripeCalibration>& calibration,
                             std::unique_ptr<sim::SimulatedRobot> simulated)
    : settings_(settings),
      simulated_(std::move(simulated)),
      renderer_(simulated_->MakeRenderer()),
      ptu_(settings.ptu.driver),
      base_(settings.base),
      lasers_(settings.stripe_camera.laser_driver),
      capture_(settings.stripe_camera.capture),
      assembler_(settings.rig, calibration, settings.recognizer.assembler),
      mission_(std::make_unique<mission::Mission>(settings.mission, settings.rig, kStart_utime,
                                                  time_s_)) {
  if (settings.sensing != Sensing::kPictures) {
    glanced_.emplace(sim::Glancer(simulated_->scene(), renderer_.built_rig(), settings.glances,
                                  simulated_->seed()),
                     settings.rig, settings.mission.seeing);
  }
  if (settings.color_camera.exposure) exposure_.emplace(*settings.color_camera.exposure);
  for (const DeviceId device : sim::kDevices) simulated_->PortOpened(device);
  ptu_.Connected(time_s_);
  base_.Connected(time_s_);
  lasers_.Connected(time_s_);
}

int64_t LockstepRobot::Utime() const { return kStart_utime + MicrosecondsFromSeconds(time_s_); }

std::string LockstepRobot::Hear(DeviceId device) {
  const std::vector<uint8_t> bytes = simulated_->Transmit(device);
  return {bytes.begin(), bytes.end()};
}

void LockstepRobot::Say(DeviceId device, std::string_view bytes) {
  simulated_->Receive(device, {reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
}

void LockstepRobot::Turn() {
  ++turns_;
  time_s_ = static_cast<double>(turns_) * kTurn_s;
  simulated_->Advance(time_s_);
  TurnPtu();
  TurnBase();
  TurnStripeCamera();
  TurnCameras();
  if (turns_ % kPlannerTurns == 0) TurnPlanner();
}

void LockstepRobot::TurnPtu() {
  Say(DeviceId::kPtu, ptu_.Step(time_s_, Hear(DeviceId::kPtu)));
  const device::PtuReport& report = ptu_.report();
  const bool ready = report.status == sensor::DeviceStatus::kReady;
  if (ready ? report.samples == ptu_samples_ : turns_ % kUnreadyTurns != 0) return;
  ptu_samples_ = report.samples;
  sensor::PtuState state = ptu::StateFromReport(report, time_s_, Utime());
  state.seq = ++ptu_seq_;
  mission_->senses()->Take(time_s_, state);
  capture_.OnPtuState(state, time_s_);
}

void LockstepRobot::TurnBase() {
  Say(DeviceId::kBase, base_.Step(time_s_, Utime(), Hear(DeviceId::kBase)));
  mission::Senses* senses = mission_->senses();
  for (const base::BaseNews& news : base_.TakeNews()) {
    senses->Take(time_s_, news.state);
    capture_.OnBaseState(news.state, time_s_);
    if (!news.measured) continue;
    senses->Take(time_s_, news.bumper);
    if (settings_.sensing == Sensing::kPerfect) continue;
    senses->Take(time_s_, news.sonar);
    senses->Take(time_s_, news.infrared);
  }
}

void LockstepRobot::TurnStripeCamera() {
  capture_.Tick(time_s_);
  lasers_.Request(capture_.wanted_laser(time_s_));
  Say(DeviceId::kLasers, lasers_.Step(time_s_, Hear(DeviceId::kLasers)));
  const device::LaserReport& report = lasers_.report();
  capture_.OnLaser(report, time_s_);
  for (sensor::Stripe& stripe : capture_.TakeAnswers()) TakeStripe(std::move(stripe));
  const bool changed = report.laser != laser_state_.laser || report.status != laser_state_.status;
  if (!changed && turns_ % kLaserStateTurns != 0) return;
  laser_state_.utime = Utime();
  laser_state_.seq += 1;
  laser_state_.status = report.status;
  laser_state_.laser = report.laser;
  laser_state_.on_time_s = report.on_time_s;
  mission_->senses()->Take(time_s_, laser_state_);
  base_.Take(laser_state_);
}

void LockstepRobot::TakeStripe(sensor::Stripe stripe) {
  if (stripe.utime == 0) stripe.utime = Utime();
  stripe.seq = ++stripe_seq_;
  recognizer::ScanAssembler::Answer answer = assembler_.Take(stripe);
  answer.profile.seq = ++profile_seq_;
  mission_->Take(answer.profile);
  if (answer.verdict) mission_->Take(*answer.verdict);
}

void LockstepRobot::TurnCameras() {
  for (const sim::Exposure& exposure : simulated_->TakeExposures()) exposed_.push_back(exposure);
  while (!exposed_.empty() && exposed_.front().end_s + settings_.frame_delay_s <= time_s_) {
    Deliver(exposed_.front());
    exposed_.pop_front();
  }
}

void LockstepRobot::Glance(const sim::Exposure& exposure) {
  constexpr double kFarthest_m = 10.0;
  mission::Senses* senses = mission_->senses();
  const sensor::Image empty = Stamped(exposure, {});
  if (exposure.camera == sim::CameraId::kHeadColor) {
    senses->TakeHeadImage(time_s_, empty, glanced_->Head(exposure));
  } else if (settings_.sensing == Sensing::kPerfect) {
    senses->TakeFloorImage(time_s_, empty, glanced_->FloorAllRound(exposure, kFarthest_m));
  } else {
    senses->TakeFloorImage(time_s_, empty, glanced_->Floor(exposure));
  }
}

void LockstepRobot::Deliver(const sim::Exposure& exposure) {
  if (glanced_ && exposure.camera != sim::CameraId::kHeadBw) {
    Glance(exposure);
    return;
  }
  const bool scanning = mission_->phase() == mission::Phase::kScan;
  switch (exposure.camera) {
    case sim::CameraId::kHeadBw:
      if (capture_.WantsFrame(exposure.start_s, time_s_)) {
        capture_.OnFrame(Taken(exposure, &renderer_), exposure.start_s, time_s_);
      }
      return;
    case sim::CameraId::kHeadColor:
      if (!scanning) TakeHeadImage(Taken(exposure, &renderer_));
      return;
    case sim::CameraId::kFloorColor:
      if (!scanning) {
        mission_->senses()->TakeFloorImage(time_s_, Taken(exposure, &renderer_));
      }
      return;
  }
}

void LockstepRobot::TakeHeadImage(sensor::Image image) {
  const auto asked_s = exposure_ ? exposure_->Judge(image) : std::nullopt;
  if (asked_s) simulated_->SetExposure(sim::CameraId::kHeadColor, *asked_s);
  head_image_ = image;
  mission_->senses()->TakeHeadImage(time_s_, std::move(image));
}

void LockstepRobot::TurnPlanner() { Obey(mission_->Step(time_s_)); }

void LockstepRobot::Obey(const mission::Wishes& wishes) {
  if (wishes.head) {
    ptu_.SetTarget({wishes.head->pan_rad, wishes.head->tilt_rad, wishes.head->speed_rad_s,
                    wishes.head->command_id});
  }
  if (wishes.target_mask) assembler_.Take(*wishes.target_mask);
  if (wishes.scan_plan) assembler_.Take(*wishes.scan_plan);
  if (wishes.scan_command) {
    capture_.OnCommand(*wishes.scan_command, time_s_);
    if (const auto verdict = assembler_.Take(*wishes.scan_command)) mission_->Take(*verdict);
  }
  if (wishes.decision) decision_ = wishes.decision;

  sensor::BaseCommand drive;
  drive.utime = Utime();
  drive.seq = ++command_seq_;
  drive.command_id = kStart_utime + command_seq_;
  drive.state_seq = mission_->senses()->base().seq;
  drive.speed_m_s = wishes.velocity.speed_m_s;
  drive.turn_rate_rad_s = wishes.velocity.turn_rate_rad_s;
  base_.Take(time_s_, drive);
}

}  // namespace geon::lockstep
