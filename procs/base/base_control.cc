#include "procs/base/base_control.h"

#include <utility>

#include "base/angles.h"
#include "base/time.h"

namespace geon::base {
namespace {

constexpr double kUnreadyPeriod_s = 0.1;
constexpr double kBumperPitch_rad = RadiansFromDegrees(18.0);

}  // namespace

DriveGuard::Bearings BumperBearings(double bumper_zero_rad, double steer_rad) {
  DriveGuard::Bearings bearings{};
  for (size_t i = 0; i < bearings.size(); ++i) {
    bearings[i] =
        WrapAngle(bumper_zero_rad + static_cast<double>(i) * kBumperPitch_rad - steer_rad);
  }
  return bearings;
}

BaseControl::BaseControl(const BaseConfig& config)
    : config_(config), driver_(config.driver), guard_(config.guard) {}

std::vector<BaseNews> BaseControl::TakeNews() { return std::exchange(news_, {}); }

std::string BaseControl::Step(double time_s, int64_t utime, std::string_view bytes_in) {
  std::string bytes_out = driver_.Step(time_s, bytes_in);
  const device::NomadReport& report = driver_.report();
  const bool ready = report.status == sensor::DeviceStatus::kReady;
  guard_.DeviceReady(ready);
  if (ready && report.samples > taken_samples_) {
    taken_samples_ = report.samples;
    guard_.BumpersRead(time_s, report.sample.bumper,
                       BumperBearings(config_.bumper_zero_rad, report.sample.steer_rad));
    bytes_out += Drive(time_s);  // a hit stops before anything is told
    TellSample(time_s, utime);
  } else if (!ready && time_s - told_s_ >= kUnreadyPeriod_s) {
    TellState(time_s, utime);
  }
  return bytes_out + Drive(time_s);
}

std::string BaseControl::Halt(double time_s, std::string_view bytes_in) {
  driver_.Halt();
  return driver_.Step(time_s, bytes_in);
}

std::string BaseControl::Drive(double time_s) {
  decision_ = guard_.Decide(time_s);
  if (decision_.moves()) {
    driver_.Drive(decision_.speed_m_s, decision_.turn_rate_rad_s);
  } else {
    driver_.Halt();
  }
  return driver_.Step(time_s, {});
}

void BaseControl::TellState(double time_s, int64_t utime) {
  const device::NomadReport& report = driver_.report();
  const device::NomadSample& sample = report.sample;
  sensor::BaseState& state = news_.emplace_back().state;
  state.utime = utime;
  if (report.samples > 0) state.utime -= MicrosecondsFromSeconds(time_s - sample.time_s);
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
  guard_.StatePublished(time_s, state.seq);
  told_s_ = time_s;
}

void BaseControl::TellSample(double time_s, int64_t utime) {
  TellState(time_s, utime);
  const device::NomadSample& sample = driver_.report().sample;
  BaseNews& news = news_.back();
  const int64_t sample_utime = news.state.utime;
  const int32_t seq = ++sensor_seq_;
  news.measured = true;
  news.sonar = {sample_utime, seq, sample.x_m, sample.y_m, sample.turret_rad, sample.sonar_m};
  news.bumper = {sample_utime, seq, guard_.contacts(),
                 BumperBearings(config_.bumper_zero_rad, sample.steer_rad), guard_.contact_count()};
  news.infrared = {sample_utime, seq, sample.infrared};
}

}  // namespace geon::base
