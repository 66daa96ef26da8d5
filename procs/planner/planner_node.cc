#include "procs/planner/planner_node.h"

#include <spdlog/spdlog.h>

#include "messaging/channels.h"
#include "messaging/clock.h"
#include "procs/planner/image_codec.h"
#include "sensor/target_view.h"

namespace geon::planner {

namespace {

constexpr double kStepPeriod_s = 0.05;  // a base command each time: the base obeys it 0.15 s
constexpr double kStatePeriod_s = 0.2;
constexpr int kViewQuality = 80;
constexpr int kStatesAfterEnd = 5;  // so that whoever listens has heard the end

}  // namespace

PlannerNode::PlannerNode(const PlannerConfig& config, messaging::Bus* bus,
                         messaging::PollLoop* loop, messaging::HealthReporter* health,
                         std::function<void()> done)
    : config_(config),
      bus_(bus),
      health_(health),
      done_(std::move(done)),
      mission_(config.mission, config.rig, messaging::Utime(), messaging::MonotonicSeconds()),
      command_id_(messaging::Utime()) {
  Subscribe();
  loop->Watch(bus->file_descriptor(), [bus] { bus->HandlePending(); });
  loop->Every(kStepPeriod_s, [this] { Step(); });
  loop->Every(kStatePeriod_s, [this] {
    SendState();
    Report();
  });
}

void PlannerNode::Subscribe() {
  mission::Senses* senses = mission_.senses();
  const auto now_s = [] { return messaging::MonotonicSeconds(); };
  bus_->Subscribe<sensor::BaseState>(messaging::kBaseState,
                                     [this, senses, now_s](const sensor::BaseState& state) {
                                       base_heard_ = true;
                                       senses->Take(now_s(), state);
                                     });
  bus_->SubscribeLatest<sensor::SonarScan>(
      messaging::kSonar, [=](const sensor::SonarScan& scan) { senses->Take(now_s(), scan); });
  bus_->Subscribe<sensor::BumperState>(
      messaging::kBumper, [=](const sensor::BumperState& state) { senses->Take(now_s(), state); });
  bus_->SubscribeLatest<sensor::InfraredScan>(
      messaging::kInfrared, [=](const sensor::InfraredScan& scan) { senses->Take(now_s(), scan); });
  bus_->Subscribe<sensor::PtuState>(
      messaging::kPtuState, [=](const sensor::PtuState& state) { senses->Take(now_s(), state); });
  bus_->Subscribe<sensor::LaserState>(messaging::kLaserState, [=](const sensor::LaserState& state) {
    senses->Take(now_s(), state);
  });
  bus_->SubscribeLatest<sensor::Image>(
      messaging::kColorImage, [this](const sensor::Image& image) { TakeHeadImage(image); });
  bus_->SubscribeLatest<sensor::Image>(
      messaging::kFloorImage, [this](const sensor::Image& image) { TakeFloorImage(image); });
  bus_->Subscribe<sensor::RangeProfile>(
      messaging::kRangeProfile,
      [this](const sensor::RangeProfile& profile) { mission_.Take(profile); });
  bus_->Subscribe<sensor::GeonVerdict>(
      messaging::kGeonVerdict,
      [this](const sensor::GeonVerdict& verdict) { mission_.Take(verdict); });
}

void PlannerNode::TakeHeadImage(const sensor::Image& image) {
  Result<sensor::Image> picture = DecodeColor(image, config_.rig.color_camera);
  if (picture.ok()) {
    mission_.senses()->TakeHeadImage(messaging::MonotonicSeconds(), *std::move(picture));
  } else if (bad_pictures_.Pass(messaging::MonotonicSeconds())) {
    spdlog::warn("{} channel={}", picture.message(), messaging::kColorImage);
  }
}

void PlannerNode::TakeFloorImage(const sensor::Image& image) {
  Result<sensor::Image> picture = DecodeColor(image, config_.rig.floor_camera);
  if (picture.ok()) {
    mission_.senses()->TakeFloorImage(messaging::MonotonicSeconds(), *std::move(picture));
  } else if (bad_pictures_.Pass(messaging::MonotonicSeconds())) {
    spdlog::warn("{} channel={}", picture.message(), messaging::kFloorImage);
  }
}

void PlannerNode::Step() {
  const mission::Wishes wishes = mission_.Step(messaging::MonotonicSeconds());
  velocity_ = wishes.velocity;
  Send(wishes);
  SendBaseCommand();
  if (mission_.phase() == told_phase_) return;
  told_phase_ = mission_.phase();
  spdlog::info("{} phase={}", mission_.State().text, ToString(told_phase_));
  SendState();
}

void PlannerNode::Send(const mission::Wishes& wishes) {
  const int64_t utime = messaging::Utime();
  const auto send = [&](std::string_view channel, auto message, int32_t* seq) {
    message.utime = utime;
    message.seq = ++*seq;
    bus_->Publish(channel, message);
  };
  if (wishes.head) send(messaging::kPtuCommand, *wishes.head, &seq_.ptu_command);
  if (wishes.target_mask) send(messaging::kTargetMask, *wishes.target_mask, &seq_.target_mask);
  if (wishes.scan_plan) send(messaging::kScanPlan, *wishes.scan_plan, &seq_.scan_plan);
  if (wishes.scan_command) send(messaging::kScanCommand, *wishes.scan_command, &seq_.scan_command);
  if (wishes.decision) SendView(*wishes.decision);
}

void PlannerNode::SendBaseCommand() {
  if (!base_heard_) return;
  sensor::BaseCommand command;
  command.utime = messaging::Utime();
  command.seq = ++seq_.base_command;
  command.command_id = ++command_id_;
  command.state_seq = mission_.senses()->base().seq;
  command.speed_m_s = velocity_.speed_m_s;
  command.turn_rate_rad_s = velocity_.turn_rate_rad_s;
  bus_->Publish(messaging::kBaseCommand, command);
}

void PlannerNode::SendState() {
  sensor::PlannerState state = mission_.State();
  state.utime = messaging::Utime();
  state.seq = ++seq_.state;
  bus_->Publish(messaging::kPlannerState, state);
  if (state.outcome == sensor::MissionOutcome::kRunning) return;
  if (++states_after_end_ == kStatesAfterEnd) done_();
}

void PlannerNode::SendView(const mission::Decision& decision) {
  const mission::HeadSighting& sighting = decision.sighting;
  sensor::TargetView view;
  view.utime = messaging::Utime();
  view.seq = ++seq_.view;
  view.scan_id = decision.scan_id;
  if (sighting.seen.target) {
    view.target_box = sighting.seen.target->box;
    view.target_pixels = sighting.seen.target->pixels;
  }
  view.pan_rad = sighting.head.pan_rad;
  view.tilt_rad = sighting.head.tilt_rad;
  view.view = EncodeJpeg(sighting.image, kViewQuality);
  if (sighting.seen.target) {
    view.mask = EncodeMask(sighting.seen.mask, sighting.seen.width_px, sighting.seen.height_px);
  }
  bus_->Publish(messaging::kTargetView, view);
}

void PlannerNode::Report() {
  const double now_s = messaging::MonotonicSeconds();
  const mission::Senses& senses = *mission_.senses();
  if (senses.BaseLost(now_s) || senses.PtuLost(now_s) || senses.HeadCameraLost(now_s) ||
      senses.FloorCameraLost(now_s)) {
    health_->SetLevel(sensor::HealthLevel::kWarn, mission_.State().text);
  } else {
    health_->SetLevel(sensor::HealthLevel::kOk);
  }
}

}  // namespace geon::planner
