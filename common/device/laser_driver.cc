#include "device/laser_driver.h"

#include <algorithm>
#include <utility>

#include "base/contracts.h"

namespace geon::device {
namespace {

constexpr int kFailuresUntilRestart = 3;  // resend that often, then restart the board
constexpr int kLaserFailuresUntilFault = 6;
constexpr double kLongestLaserNoise_s = 2.0;  // a line that is never quiet is used after this

constexpr int IndexOf(sensor::Laser laser) {
  return laser == sensor::Laser::kNone ? -1 : static_cast<int>(laser) - 1;
}
constexpr sensor::Laser LaserAt(int index) { return static_cast<sensor::Laser>(index + 1); }

}  // namespace

LaserDriver::LaserDriver(const LaserDriverOptions& options) : options_(options) {
  Require(options.reply_timeout_s > 0.0 && options.start_timeout_s > 0.0 && options.quiet_s > 0.0 &&
              options.refresh_period_s > 0.0,
          "LaserDriverOptions: every time must be positive");
  report_.text = "no line to the laser board yet";
}

void LaserDriver::Connected(double time_s) {
  // Opening the port may have restarted the board, whose boot loader swallows what is said now:
  // first listen, then ask for a restart.
  LoseStep(time_s);
  failures_ = kFailuresUntilRestart;
  foreign_ = false;
  restart_expected_ = true;
  last_step_s_ = time_s;
  report_.text = "starting";
  UpdateReport();
}

void LaserDriver::Disconnected(double time_s) {
  LoseStep(time_s);
  phase_ = Phase::kClosed;
  wanted_ = sensor::Laser::kNone;
  report_.text = "the line to the laser board is gone";
  UpdateReport();
}

void LaserDriver::LoseStep(double time_s) {
  outstanding_.reset();
  reader_.Clear();
  lamps_ = {Lamp::kUnknown, Lamp::kUnknown};
  in_step_ = false;
  phase_ = Phase::kQuiet;
  phase_since_s_ = last_byte_s_ = time_s;
}

std::string LaserDriver::Step(double time_s, std::string_view bytes_in) {
  if (may_burn_ != sensor::Laser::kNone) report_.on_time_s += std::max(0.0, time_s - last_step_s_);
  last_step_s_ = time_s;
  if (phase_ == Phase::kClosed) return {};
  if (!bytes_in.empty()) last_byte_s_ = time_s;
  Receive(time_s, bytes_in);
  std::string bytes_out = NextCommand(time_s);
  UpdateReport();
  return bytes_out;
}

void LaserDriver::Receive(double time_s, std::string_view bytes) {
  reader_.Push(bytes);
  while (const std::optional<HorusLine> line = reader_.Next()) HandleLine(time_s, *line);
}

void LaserDriver::HandleLine(double time_s, const HorusLine& line) {
  using Kind = HorusLine::Kind;
  if (line.kind == Kind::kNote) return;
  if (line.kind == Kind::kBanner) return Restarted(time_s);
  if (line.kind == Kind::kForeignBanner) {
    foreign_ = true;
    Surprise(time_s, "the laser board says \"" + line.text + "\"; it needs firmware Horus 0.2");
    return;
  }
  if (phase_ != Phase::kRunning) return;  // left over from before
  if (line.kind == Kind::kOk && outstanding_) return Confirm(time_s);
  Surprise(time_s, outstanding_ ? "the laser board answered \"" + line.text + "\""
                                : "the laser board said \"" + line.text + "\" unasked");
}

void LaserDriver::Confirm(double time_s) {
  Lamp& lamp = lamps_[static_cast<size_t>(outstanding_->laser)];
  const Lamp confirmed = outstanding_->on ? Lamp::kOn : Lamp::kOff;
  if (lamp != confirmed) report_.confirmed_time_s = time_s;
  lamp = confirmed;
  if (!outstanding_->on && may_burn_ == LaserAt(outstanding_->laser)) {
    may_burn_ = sensor::Laser::kNone;
  }
  outstanding_.reset();
  failures_ = 0;
}

// The firmware starts with both lasers off. That is still said and confirmed before use.
void LaserDriver::Restarted(double time_s) {
  if (!std::exchange(restart_expected_, false)) {
    ++report_.restarts;
    report_.text = "the laser board restarted";
  }
  LoseStep(time_s);
  phase_ = Phase::kRunning;
  may_burn_ = sensor::Laser::kNone;
  foreign_ = false;
}

void LaserDriver::Surprise(double time_s, const std::string& what) {
  ++failures_;
  ++report_.errors;
  report_.text = what;
  LoseStep(time_s);
}

std::string LaserDriver::NextCommand(double time_s) {
  if (phase_ == Phase::kQuiet) {
    const bool quiet = time_s - last_byte_s_ >= options_.quiet_s;
    if (!quiet && time_s - phase_since_s_ < kLongestLaserNoise_s) return {};
    reader_.Clear();
    phase_since_s_ = last_refresh_s_ = time_s;
    if (failures_ >= kFailuresUntilRestart) {
      phase_ = Phase::kStarting;
      restart_expected_ = true;
      return EncodeHorusReset();
    }
    phase_ = Phase::kRunning;
  }
  if (phase_ == Phase::kStarting) {
    if (time_s - phase_since_s_ < options_.start_timeout_s) return {};
    Surprise(time_s, foreign_ ? report_.text : "no laser board answers (Horus at 115200 baud?)");
    return {};
  }
  if (outstanding_) {
    if (time_s < outstanding_->deadline_s) return {};
    Surprise(time_s, "the laser board did not answer");
    return {};
  }
  const int wanted = IndexOf(wanted_);
  for (int i = 0; i < 2; ++i) {
    if (i != wanted && lamps_[static_cast<size_t>(i)] != Lamp::kOff) return Send(time_s, i, false);
  }
  if (wanted >= 0 && lamps_[static_cast<size_t>(wanted)] != Lamp::kOn) {
    return Send(time_s, wanted, true);
  }
  if (time_s - last_refresh_s_ < options_.refresh_period_s) return {};
  refreshed_ = 1 - refreshed_;
  return Send(time_s, refreshed_, refreshed_ == wanted);
}

std::string LaserDriver::Send(double time_s, int laser, bool on) {
  // The one place that lights a laser, and the one rule above all others.
  Require(!on || lamps_[static_cast<size_t>(1 - laser)] == Lamp::kOff,
          "a laser is lit only when the other is known to be off");
  Lamp& lamp = lamps_[static_cast<size_t>(laser)];
  if (lamp != (on ? Lamp::kOn : Lamp::kOff)) lamp = Lamp::kUnknown;
  outstanding_ = Outstanding{laser, on, time_s + options_.reply_timeout_s};
  last_refresh_s_ = time_s;
  if (on) may_burn_ = LaserAt(laser);
  return on ? EncodeLaserOn(laser + 1) : EncodeLaserOff(laser + 1);
}

void LaserDriver::UpdateReport() {
  using sensor::DeviceStatus;
  const bool known = lamps_[0] != Lamp::kUnknown && lamps_[1] != Lamp::kUnknown;
  if (phase_ == Phase::kRunning && known) {
    in_step_ = true;
    report_.text.clear();
  }
  report_.confirmed = in_step_ && known;
  report_.laser = may_burn_;
  if (phase_ == Phase::kClosed) {
    report_.status = DeviceStatus::kUnknown;
  } else if (in_step_) {
    report_.status = DeviceStatus::kReady;
  } else {
    const bool fault = foreign_ || failures_ >= kLaserFailuresUntilFault;
    report_.status = fault ? DeviceStatus::kFault : DeviceStatus::kStarting;
  }
}

Status SwitchOffNow(SerialLink* link, double patience_s) {
  // The first line end closes a half-sent command; the restart at the end needs no answer.
  constexpr double kTurn_s = 0.01;
  HorusReader reader;
  int confirmed = 0;
  link->Send("\r\n" + EncodeLaserOff(1) + EncodeLaserOff(2));
  for (double waited_s = 0.0; waited_s < patience_s && confirmed < 2 && link->is_open();
       waited_s += kTurn_s) {
    link->WaitReadable(kTurn_s);
    reader.Push(link->Service(0.0).bytes);
    while (const std::optional<HorusLine> line = reader.Next()) {
      if (line->kind == HorusLine::Kind::kOk) ++confirmed;
    }
  }
  if (confirmed >= 2) return Status::Ok();
  link->Send(EncodeHorusReset());
  return Status::Error("the laser board did not confirm that both lasers are off; look at them");
}

}  // namespace geon::device
