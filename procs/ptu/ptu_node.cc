#include "procs/ptu/ptu_node.h"

#include <spdlog/spdlog.h>

#include <cmath>

#include "base/time.h"
#include "messaging/channels.h"
#include "messaging/clock.h"

namespace geon::ptu {
namespace {

constexpr double kTurnPeriod_s = 0.005;
constexpr double kUnreadyPeriod_s = 0.1;

}  // namespace

sensor::PtuState StateFromReport(const device::PtuReport& report, double time_s, int64_t utime) {
  sensor::PtuState state;
  state.utime = utime;
  state.status = report.status;
  state.command_id = report.command_id;
  if (report.status != sensor::DeviceStatus::kReady || report.samples == 0) return state;
  state.utime -= MicrosecondsFromSeconds(time_s - report.sample_time_s);
  state.pan_rad = report.pan_rad;
  state.tilt_rad = report.tilt_rad;
  state.pan_target_rad = report.pan_target_rad;
  state.tilt_target_rad = report.tilt_target_rad;
  state.pan_min_rad = report.pan_min_rad;
  state.pan_max_rad = report.pan_max_rad;
  state.tilt_min_rad = report.tilt_min_rad;
  state.tilt_max_rad = report.tilt_max_rad;
  state.moving = report.moving;
  return state;
}

PtuNode::PtuNode(const PtuConfig& config, messaging::Bus* bus, messaging::PollLoop* loop,
                 messaging::HealthReporter* health)
    : link_(config.link), driver_(config.driver), bus_(bus), health_(health) {
  bus->SubscribeLatest<sensor::PtuCommand>(
      messaging::kPtuCommand,
      [this](const sensor::PtuCommand& command) { HandleCommand(command); });
  loop->Watch(bus->file_descriptor(), [bus] { bus->HandlePending(); });
  loop->Every(kTurnPeriod_s, [this] { Turn(); });
}

void PtuNode::HandleCommand(const sensor::PtuCommand& command) {
  if (!std::isfinite(command.pan_rad) || !std::isfinite(command.tilt_rad) ||
      !std::isfinite(command.speed_rad_s) || command.speed_rad_s < 0.0) {
    spdlog::warn("refused a command that is not a number command_id={}", command.command_id);
    return;
  }
  driver_.SetTarget({command.pan_rad, command.tilt_rad, command.speed_rad_s, command.command_id});
}

void PtuNode::Turn() {
  const double time_s = messaging::MonotonicSeconds();
  device::Pump(&link_, &driver_, time_s);
  const device::PtuReport& report = driver_.report();
  const bool ready = report.status == sensor::DeviceStatus::kReady;
  if (ready ? report.samples > published_samples_ : time_s - published_s_ >= kUnreadyPeriod_s) {
    Publish(time_s);
  }
  ReportHealth();
}

void PtuNode::Publish(double time_s) {
  published_samples_ = driver_.report().samples;
  published_s_ = time_s;
  sensor::PtuState state = StateFromReport(driver_.report(), time_s, messaging::Utime());
  state.seq = ++seq_;
  bus_->Publish(messaging::kPtuState, state);
}

void PtuNode::ReportHealth() {
  const device::PtuReport& report = driver_.report();
  const std::string& trouble = link_.is_open() ? report.text : link_.trouble();
  health_->SetLevel(sensor::LevelOf(report.status), trouble);
  health_->set_reconnects(link_.reconnects() + report.recoveries);
  if (trouble == said_) return;
  said_ = trouble;
  if (trouble.empty()) {
    spdlog::info("ready unit=\"{}\"", report.version);
  } else {
    spdlog::warn("{}", trouble);
  }
}

}  // namespace geon::ptu
