#include "procs/base/base_node.h"

#include <spdlog/spdlog.h>

#include <utility>

#include "device/nomad_codec.h"
#include "messaging/channels.h"
#include "messaging/clock.h"

namespace geon::base {
namespace {

constexpr double kTurnPeriod_s = 0.005;

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

BaseNode::BaseNode(const BaseConfig& config, messaging::Bus* bus, messaging::PollLoop* loop,
                   messaging::HealthReporter* health)
    : config_(config), link_(config.link), control_(config), bus_(bus), health_(health) {
  // Every command in its order: which of them is news is for the guard to judge.
  bus->Subscribe<sensor::BaseCommand>(messaging::kBaseCommand,
                                      [this](const sensor::BaseCommand& command) {
                                        control_.Take(messaging::MonotonicSeconds(), command);
                                      });
  bus->SubscribeLatest<sensor::LaserState>(
      messaging::kLaserState, [this](const sensor::LaserState& lasers) { control_.Take(lasers); });
  loop->Watch(bus->file_descriptor(), [bus] { bus->HandlePending(); });
  loop->Every(kTurnPeriod_s, [this] { Turn(); });
  loop->OnStop([this] { StopRobot(); });
}

std::string BaseNode::ServiceLink(double time_s) {
  device::SerialLink::Traffic traffic = link_.Service(time_s);
  if (traffic.lost) control_.Disconnected(time_s);
  if (traffic.opened) control_.Connected(time_s);
  return std::move(traffic.bytes);
}

void BaseNode::Turn() {
  const double time_s = messaging::MonotonicSeconds();
  link_.Send(control_.Step(time_s, messaging::Utime(), ServiceLink(time_s)));
  Publish();
  if (control_.stop() != said_stop_) {
    said_stop_ = control_.stop();
    spdlog::info("{}", Words(said_stop_));
  }
  ReportHealth();
}

void BaseNode::Publish() {
  for (const BaseNews& news : control_.TakeNews()) {
    bus_->Publish(messaging::kBaseState, news.state);
    if (!news.measured) continue;
    bus_->Publish(messaging::kSonar, news.sonar);
    bus_->Publish(messaging::kBumper, news.bumper);
    bus_->Publish(messaging::kInfrared, news.infrared);
  }
}

void BaseNode::ReportHealth() {
  const device::NomadReport& report = control_.report();
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
  for (double now_s = 0.0; now_s < give_up_s && link_.is_open() && !control_.report().halted;) {
    now_s = messaging::MonotonicSeconds();
    link_.Send(control_.Halt(now_s, ServiceLink(now_s)));
    link_.WaitReadable(kTurn_s);
  }
  if (!link_.is_open()) return;
  if (!control_.report().halted) {
    spdlog::warn("the base did not confirm the stop; its dead-man stops it in {} s",
                 config_.driver.dead_man_s);
  }
  link_.Send(device::EncodeNomadFrame(device::NomadType::kStop) + device::EncodeVelocity(0, 0, 0));
}

}  // namespace geon::base
