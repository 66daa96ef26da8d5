#include "device/ptu_driver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::device {
namespace {

constexpr double kLongestPtuNoise_s = 2.0;  // a line that is never quiet is used after this
constexpr double kUnendedLine_s = 0.3;      // silence that ends the answer to R without a line end
constexpr int kPtuFailuresUntilFault = 5;
constexpr int kStallsUntilReset = 2;
constexpr int kLargestCount = 100'000;  // a turn is 7000 counts at the usual resolution
constexpr int kLargestSpeed = 100'000;

}  // namespace

PtuDriver::PtuDriver(const PtuDriverOptions& options) : options_(options) {
  Require(options.poll_period_s > 0.0 && options.reply_timeout_s > 0.0 &&
              options.reset_timeout_s > 0.0 && options.quiet_s > 0.0 && options.stall_s > 0.0 &&
              options.speed_rad_s > 0.0,
          "PtuDriverOptions: every time and speed must be positive");
  tilt_.letter = 'T';
  report_.text = "no line to the pan-tilt unit yet";
}

void PtuDriver::SetTarget(const PtuTarget& target) {
  Require(std::isfinite(target.pan_rad) && std::isfinite(target.tilt_rad) &&
              std::isfinite(target.speed_rad_s),
          "PtuTarget must be finite");
  target_ = target;
}

void PtuDriver::Connected(double time_s) {
  failures_ = stalls_ = 0;
  reset_wanted_ = options_.reset_at_start;
  report_.text = "starting";
  Enter(Phase::kQuiet, time_s);
}

void PtuDriver::Disconnected(double time_s) {
  Enter(Phase::kClosed, time_s);
  report_.text = "the line to the pan-tilt unit is gone";
}

void PtuDriver::Enter(Phase phase, double time_s) {
  using sensor::DeviceStatus;
  phase_ = phase;
  phase_since_s_ = last_byte_s_ = time_s;
  if (phase != Phase::kRunning) report_.moving = false;
  if (phase == Phase::kClosed || phase == Phase::kQuiet) {
    queue_.clear();
    outstanding_ = false;
    reader_.Clear();
  }
  switch (phase) {
    case Phase::kClosed:
      report_.status = DeviceStatus::kUnknown;
      break;
    case Phase::kRunning:
      report_.status = DeviceStatus::kReady;
      report_.text.clear();
      failures_ = 0;
      break;
    default:
      report_.status =
          failures_ >= kPtuFailuresUntilFault ? DeviceStatus::kFault : DeviceStatus::kStarting;
  }
}

void PtuDriver::Surprise(double time_s, const std::string& what) {
  if (phase_ == Phase::kRunning) ++report_.recoveries;
  ++failures_;
  report_.text = what;
  Enter(Phase::kQuiet, time_s);
}

std::string PtuDriver::Step(double time_s, std::string_view bytes_in) {
  now_s_ = time_s;
  if (phase_ == Phase::kClosed) return {};
  if (!bytes_in.empty()) last_byte_s_ = time_s;
  Receive(time_s, bytes_in);
  std::string bytes_out = AdvancePhase(time_s);
  return bytes_out + SendNext(time_s);
}

void PtuDriver::Receive(double time_s, std::string_view bytes) {
  reader_.Push(bytes);
  HandleLimits(time_s);
  while (const std::optional<PtuLine> line = reader_.Next()) HandleLine(time_s, *line);
  // Some firmware ends the answer to R with a bare star.
  if (outstanding_ && queue_.front().is_reset && time_s - last_byte_s_ >= kUnendedLine_s) {
    if (const std::optional<PtuLine> line = reader_.TakeUnfinished()) HandleLine(time_s, *line);
  }
}

void PtuDriver::HandleLine(double time_s, const PtuLine& line) {
  using Kind = PtuLine::Kind;
  const bool in_step = phase_ == Phase::kInitialising || phase_ == Phase::kRunning;
  if (line.kind == Kind::kBanner) {
    // It has just hunted for its limits: marks on the way there are forgotten by Enter().
    reset_wanted_ = false;
    Surprise(time_s, "the unit was power-cycled");
    return;
  }
  if (!in_step) return;
  if (!outstanding_) return Surprise(time_s, "an answer nobody asked for");
  const Request request = queue_.front();
  const std::string asked = request.command.substr(0, request.command.size() - 1);
  if (!line.echo.empty() && !request.may_echo) {
    return Surprise(time_s, "echo or noise before the answer to " + asked);
  }
  if (line.kind == Kind::kRefused && !request.may_refuse) {
    return Surprise(time_s, asked + " was refused: " + line.text);
  }
  if (line.kind == Kind::kUnknown || (line.kind == Kind::kDone && !request.accept(line))) {
    return Surprise(time_s, "\"" + line.text + "\" does not answer " + asked);
  }
  outstanding_ = false;
  queue_.pop_front();
}

void PtuDriver::HandleLimits(double time_s) {
  const bool pan = reader_.TakePanLimit();
  const bool tilt = reader_.TakeTiltLimit();
  const bool in_reset = outstanding_ && queue_.front().is_reset;
  if (!(pan || tilt) || in_reset) return;
  report_.limit_hits += (pan ? 1 : 0) + (tilt ? 1 : 0);
  reset_wanted_ = true;
  if (phase_ == Phase::kRunning || phase_ == Phase::kInitialising) {
    Surprise(time_s, std::string(pan ? "pan" : "tilt") + " hit a limit and lost its reference");
  }
}

std::string PtuDriver::AdvancePhase(double time_s) {
  if (outstanding_ && time_s >= deadline_s_) {
    const std::string command = queue_.front().command;
    Surprise(time_s, failures_ == 0 ? "no answer to " + command
                                    : "no pan-tilt unit answers (9600 baud, powered, right port?)");
  }
  if (std::exchange(stalled_, false)) Surprise(time_s, "the head stands short of its target");
  if (phase_ == Phase::kQuiet || phase_ == Phase::kFlush) {
    const bool quiet = time_s - last_byte_s_ >= options_.quiet_s;
    if (!quiet && time_s - phase_since_s_ < kLongestPtuNoise_s) return {};
    reader_.Clear();
    if (phase_ == Phase::kQuiet) {
      // A bare delimiter ends whatever half command the unit holds.
      Enter(Phase::kFlush, time_s);
      return EncodePtuCommand("");
    }
    Enter(Phase::kInitialising, time_s);
    QueueInitialisation();
  } else if (phase_ == Phase::kInitialising && queue_.empty()) {
    Enter(Phase::kRunning, time_s);
    next_poll_s_ = still_since_s_ = time_s;
  }
  if (phase_ == Phase::kRunning && queue_.empty()) {
    QueueTarget();
    if (queue_.empty() && time_s >= next_poll_s_) {
      next_poll_s_ = std::max(next_poll_s_ + options_.poll_period_s, time_s);
      QueuePoll();
    }
  }
  return {};
}

std::string PtuDriver::SendNext(double time_s) {
  if (outstanding_ || queue_.empty()) return {};
  outstanding_ = true;
  sent_s_ = time_s;
  deadline_s_ = time_s + queue_.front().timeout_s;
  return queue_.front().command;
}

void PtuDriver::QueueInitialisation() {
  for (Axis* axis : {&pan_, &tilt_}) axis->target_count.reset();
  // Until ED has worked, the unit may echo; a unit that is already terse does not mind.
  QueuePlain("ED", {.may_echo = true});
  QueuePlain("FT", {});
  queue_.push_back({.command = EncodePtuCommand("V"),
                    .timeout_s = options_.reply_timeout_s,
                    .accept = [this](const PtuLine& line) {
                      report_.version = line.text;
                      return !line.text.empty();
                    }});
  QueuePlain("CI", {.may_refuse = true});  // old firmware knows no other control mode
  QueuePlain("I", {});
  QueuePlain("LE", {});
  if (reset_wanted_) QueueReset();
  for (Axis* axis : {&pan_, &tilt_}) QueueAxisQueries(axis);
}

void PtuDriver::QueuePlain(const std::string& letters, const Leniency& leniency) {
  queue_.push_back({.command = EncodePtuCommand(letters),
                    .timeout_s = options_.reply_timeout_s,
                    .accept = [](const PtuLine&) { return true; },
                    .may_refuse = leniency.may_refuse,
                    .may_echo = leniency.may_echo});
}

void PtuDriver::QueueReset() {
  report_.text = "finding the limits anew";
  queue_.push_back({.command = EncodePtuCommand("R"),
                    .timeout_s = options_.reset_timeout_s,
                    .accept =
                        [this](const PtuLine&) {
                          reset_wanted_ = false;
                          stalls_ = 0;
                          return true;
                        },
                    .is_reset = true});
}

void PtuDriver::QueueCount(const std::string& letters, int lowest, int highest, int* count) {
  queue_.push_back({.command = EncodePtuCommand(letters),
                    .timeout_s = options_.reply_timeout_s,
                    .accept = [=](const PtuLine& line) {
                      const std::optional<int> value = ParsePtuCount(line.text);
                      if (!value || *value < lowest || *value > highest) return false;
                      *count = *value;
                      return true;
                    }});
}

void PtuDriver::QueueAxisQueries(Axis* axis) {
  const std::string letter(1, axis->letter);
  queue_.push_back({.command = EncodePtuCommand(letter + "R"),
                    .timeout_s = options_.reply_timeout_s,
                    .accept = [axis](const PtuLine& line) {
                      constexpr double kLargestArcSeconds = 3600.0;
                      const std::optional<double> value = ParsePtuNumber(line.text);
                      if (!value || *value <= 0.0 || *value > kLargestArcSeconds) return false;
                      axis->resolution_rad = RadiansFromDegrees(*value / 3600.0);
                      return true;
                    }});
  QueueCount(letter + "N", -kLargestCount, 0, &axis->min_count);
  QueueCount(letter + "X", 0, kLargestCount, &axis->max_count);
  QueueCount(letter + "L", 0, kLargestSpeed, &axis->lower_speed);
  QueueCount(letter + "U", 1, kLargestSpeed, &axis->upper_speed);
}

void PtuDriver::QueueTarget() {
  if (!target_) return;
  bool accepted = true;
  for (Axis* axis : {&pan_, &tilt_}) {
    const int count = TargetCount(*axis, axis == &pan_ ? target_->pan_rad : target_->tilt_rad);
    const int speed = SpeedCount(*axis, target_->speed_rad_s);
    if (axis->target_count == count && axis->speed == speed) continue;
    accepted = false;
    const std::string letter(1, axis->letter);
    const auto set = [this](const std::string& letters, int value, std::function<void()> done) {
      queue_.push_back({.command = EncodePtuCommand(letters, value),
                        .timeout_s = options_.reply_timeout_s,
                        .accept = [done = std::move(done)](const PtuLine& line) {
                          if (!line.text.empty()) return false;
                          done();
                          return true;
                        }});
    };
    set(letter + "S", speed, [axis, speed] { axis->speed = speed; });
    set(letter + "P", count, [axis, count] { axis->target_count = count; });
  }
  if (!accepted) {
    report_.moving = true;
    still_since_s_ = now_s_;
    return;
  }
  report_.command_id = target_->command_id;
  report_.pan_target_rad = *pan_.target_count * pan_.resolution_rad;
  report_.tilt_target_rad = *tilt_.target_count * tilt_.resolution_rad;
}

void PtuDriver::QueuePoll() {
  QueuePosition("PP", &pan_);
  QueuePosition("TP", &tilt_);
  // Taken with the second answer.
  queue_.back().accept = [this, accept = queue_.back().accept](const PtuLine& line) {
    if (!accept(line)) return false;
    TakeSample(now_s_);
    return true;
  };
}

// The unit reads its counter when it has the question: on a slow line that is well before its
// answer is here. Question and answer share the time between in proportion to their bytes.
void PtuDriver::QueuePosition(const std::string& letters, Axis* axis) {
  axis->last_count = axis->count;
  axis->last_read_s = axis->read_s;
  // A position outside the limits is not a position.
  QueueCount(letters, axis->min_count, axis->max_count, &axis->count);
  const double asked_bytes = static_cast<double>(queue_.back().command.size());
  queue_.back().accept = [this, axis, asked_bytes,
                          accept = queue_.back().accept](const PtuLine& line) {
    constexpr double kFrame_bytes = 4.0;  // star, blank, end of line
    const double answer_bytes = static_cast<double>(line.text.size()) + kFrame_bytes;
    axis->read_s = sent_s_ + (now_s_ - sent_s_) * asked_bytes / (asked_bytes + answer_bytes);
    return accept(line);
  };
}

// Where an axis that has gone on as it did is now, but not past its target.
double PtuDriver::CountAt(const Axis& axis, double time_s) const {
  const double between_s = axis.read_s - axis.last_read_s;
  if (axis.count == axis.last_count || !axis.target_count || between_s <= 0.0) return axis.count;
  const double gone = (axis.count - axis.last_count) / between_s * (time_s - axis.read_s);
  const double left = *axis.target_count - axis.count;
  return axis.count + std::clamp(gone, std::min(left, 0.0), std::max(left, 0.0));
}

void PtuDriver::TakeSample(double time_s) {
  bool changed = false;
  bool off_target = false;
  for (const Axis* axis : {&pan_, &tilt_}) {
    changed |= axis->count != axis->last_count;
    off_target |= axis->target_count && axis->count != *axis->target_count;
  }
  ++report_.samples;
  // Both as of the tilt's reading; the pan's is a question older.
  report_.sample_time_s = tilt_.read_s;
  report_.pan_rad = CountAt(pan_, tilt_.read_s) * pan_.resolution_rad;
  report_.tilt_rad = tilt_.count * tilt_.resolution_rad;
  report_.pan_min_rad = pan_.min_count * pan_.resolution_rad;
  report_.pan_max_rad = pan_.max_count * pan_.resolution_rad;
  report_.tilt_min_rad = tilt_.min_count * tilt_.resolution_rad;
  report_.tilt_max_rad = tilt_.max_count * tilt_.resolution_rad;
  if (!pan_.target_count) {
    report_.pan_target_rad = report_.pan_rad;
    report_.tilt_target_rad = report_.tilt_rad;
  }
  report_.moving = changed || off_target;
  if (changed || !off_target) {
    still_since_s_ = time_s;
    if (!off_target) stalls_ = 0;
  } else if (time_s - still_since_s_ >= options_.stall_s) {
    if (++stalls_ >= kStallsUntilReset) reset_wanted_ = true;
    stalled_ = true;
  }
}

int PtuDriver::TargetCount(const Axis& axis, double angle_rad) const {
  const double count = angle_rad / axis.resolution_rad;
  return static_cast<int>(std::lround(
      std::clamp(count, static_cast<double>(axis.min_count), static_cast<double>(axis.max_count))));
}

int PtuDriver::SpeedCount(const Axis& axis, double speed_rad_s) const {
  const double speed = (speed_rad_s > 0.0 ? speed_rad_s : options_.speed_rad_s);
  return static_cast<int>(
      std::lround(std::clamp(speed / axis.resolution_rad, static_cast<double>(axis.lower_speed),
                             static_cast<double>(std::max(axis.lower_speed, axis.upper_speed)))));
}

}  // namespace geon::device
