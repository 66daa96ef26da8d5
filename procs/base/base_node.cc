#include "procs/base/base_node.h"

#include <spdlog/spdlog.h>

#include "base/angles.h"
#include "base/time.h"
#include "messaging/channels.h"
#include "messaging/clock.h"

namespace geon::base {
namespace {

constexpr double kTurnPeriod_s = 0.005;
constexpr double kUnreadyPeriod_s = 0.1;
constexpr double kBumperPitch_rad = RadiansFromDegrees(18.0);

const char* Words(sensor::BaseStop stop) {
  switch (stop) {
    case sensor::BaseStop::kNone:
      return "free to drive";
    case sensor::BaseStop::kBumper:
      return "stopped: a bumper touches";
    case sensor::BaseStop::kCommandExpired:
      return "stopped: no fresh command";
    case sensor::BaseStop::kStaleCommand:
      return "stopped: commands answer a state that is too old";
    case sensor::BaseStop::kDeviceLost:
      return "stopped: the base does not answer";
    case sensor::BaseStop::kLaserOn:
      return "stopped: a laser burns";
  }
  return "";
}

}  // namespace

DriveGuard::Bearings BumperBearings(double bumper_zero_rad, double steer_rad) {
  DriveGuard::Bearings bearings{};
  for (size_t i = 0; i < bearings.size(); ++i) {
    bearings[i] =
        WrapAngle(bumper_zero_rad + static_cast<double>(i) * kBumperPitch_rad - steer_rad);
  }
  return bearings;
}

BaseNode::BaseNode(const BaseConfig& config, messaging::Bus* bus, messaging::PollLoop* loop,
                   messaging::HealthReporter* health)
    : config_(config),
      link_(config.link),
      driver_(config.driver),
      guard_(config.guard),
      bus_(bus),
      health_(health) {
  // Every command in its order: which of them is news is for the guard to judge.
  bus->Subscribe<sensor::BaseCommand>(
      messaging::kBaseCommand, [this](const sensor::BaseCommand& command) {
        guard_.CommandArrived(messaging::MonotonicSeconds(), command);
      });
  bus->SubscribeLatest<sensor::LaserState>(
      messaging::kLaserState,
      [this](const sensor::LaserState& lasers) { guard_.LasersReported(lasers); });
  loop->Watch(bus->file_descriptor(), [bus] { bus->HandlePending(); });
  loop->Every(kTurnPeriod_s, [this] { Turn(); });
  loop->OnStop([this] { StopRobot(); });
}

void BaseNode::Turn() {
  const double time_s = messaging::MonotonicSeconds();
  device::Pump(&link_, &driver_, time_s);
  const device::NomadReport& report = driver_.report();
  const bool ready = report.status == sensor::DeviceStatus::kReady;
  guard_.DeviceReady(ready);
  if (ready && report.samples > taken_samples_) {
    TakeSample(time_s);
  } else if (!ready && time_s - published_s_ >= kUnreadyPeriod_s) {
    PublishState(time_s);
  }
  Drive(time_s);
  ReportHealth();
}

void BaseNode::TakeSample(double time_s) {
  const device::NomadSample& sample = driver_.report().sample;
  taken_samples_ = driver_.report().samples;
  guard_.BumpersRead(time_s, sample.bumper,
                     BumperBearings(config_.bumper_zero_rad, sample.steer_rad));
  Drive(time_s);  // a hit stops before anything is told
  PublishState(time_s);
  PublishSensors(time_s);
}

void BaseNode::Drive(double time_s) {
  decision_ = guard_.Decide(time_s);
  if (decision_.moves()) {
    driver_.Drive(decision_.speed_m_s, decision_.turn_rate_rad_s);
  } else {
    driver_.Halt();
  }
  link_.Send(driver_.Step(time_s, {}));
  if (decision_.stop == said_stop_) return;
  said_stop_ = decision_.stop;
  spdlog::info("{}", Words(said_stop_));
}

int64_t BaseNode::SampleUtime(double time_s) const {
  return messaging::Utime() - MicrosecondsFromSeconds(time_s - driver_.report().sample.time_s);
}

void BaseNode::PublishState(double time_s) {
  const device::NomadReport& report = driver_.report();
  const device::NomadSample& sample = report.sample;
  const bool known = report.samples > 0;
  sensor::BaseState state;
  state.utime = known ? SampleUtime(time_s) : messaging::Utime();
  state.seq = ++state_seq_;
  state.status = report.status;
  state.x_m = sample.x_m;
  state.y_m = sample.y_m;
  state.heading_rad = sample.steer_rad;
  state.speed_m_s = sample.speed_m_s;
  state.turn_rate_rad_s = sample.turn_rate_rad_s;
  state.moving = sample.moving;
  state.stop = decision_.stop;
  state.command_id = guard_.command_id();
  bus_->Publish(messaging::kBaseState, state);
  guard_.StatePublished(time_s, state.seq);
  published_s_ = time_s;
}

void BaseNode::PublishSensors(double time_s) {
  const device::NomadSample& sample = driver_.report().sample;
  const int64_t utime = SampleUtime(time_s);
  const int32_t seq = ++sensor_seq_;
  sensor::SonarScan sonar{utime, seq, sample.x_m, sample.y_m, sample.turret_rad, sample.sonar_m};
  bus_->Publish(messaging::kSonar, sonar);
  sensor::BumperState bumper{utime, seq, guard_.contacts(),
                             BumperBearings(config_.bumper_zero_rad, sample.steer_rad),
                             guard_.contact_count()};
  bus_->Publish(messaging::kBumper, bumper);
  bus_->Publish(messaging::kInfrared, sensor::InfraredScan{utime, seq, sample.infrared});
}

void BaseNode::ReportHealth() {
  const device::NomadReport& report = driver_.report();
  const std::string& trouble = link_.is_open() ? report.text : link_.trouble();
  health_->SetLevel(sensor::LevelOf(report.status), trouble);
  health_->set_reconnects(link_.reconnects() + report.recoveries);
  if (trouble == said_) return;
  said_ = trouble;
  if (trouble.empty()) {
    spdlog::info("ready motor_v={:.1f} cpu_v={:.1f}", report.sample.motor_volts,
                 report.sample.cpu_volts);
  } else {
    spdlog::warn("{}", trouble);
  }
}

// Until the robot has confirmed that it stands, but not for ever: its dead-man does the rest.
void BaseNode::StopRobot() {
  constexpr double kPatience_s = 0.7;
  constexpr double kTurn_s = 0.005;
  const double give_up_s = messaging::MonotonicSeconds() + kPatience_s;
  driver_.Halt();
  for (double now_s = 0.0; now_s < give_up_s && link_.is_open() && !driver_.report().halted;) {
    now_s = messaging::MonotonicSeconds();
    device::Pump(&link_, &driver_, now_s);
    link_.WaitReadable(kTurn_s);
  }
  if (!link_.is_open()) return;
  if (!driver_.report().halted) {
    spdlog::warn("the base did not confirm the stop; its dead-man stops it in {} s",
                 config_.driver.dead_man_s);
  }
  link_.Send(device::EncodeNomadFrame(device::NomadType::kStop) + device::EncodeVelocity(0, 0, 0));
}

}  // namespace geon::base
