#include "sim/horus_emulator.h"

#include <charconv>
#include <cstdio>

namespace geon::sim {
namespace {

constexpr double kHorusTick_s = 0.001;
constexpr size_t kLineLength = 79;
constexpr size_t kBufferLength = 127;
constexpr size_t kQueuedMoves = 15;
constexpr uint8_t kReset = 0x18;
constexpr char kHorusBanner[] = "\r\nHorus 0.2 ['$' for help]\r\n";
constexpr char kHelp[] =
    "$$ (view settings)\r\n$x=value (save setting)\r\n$X (kill alarm lock)\r\n"
    "~ (cycle start)\r\n! (feed hold)\r\n? (current status)\r\nctrl-x (reset)\r\n";

std::string Format(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

HorusEmulator::HorusEmulator(const HorusEmulatorOptions& options)
    : options_(options), from_host_(options.baud), to_host_(options.baud) {
  PowerCycle(0.0);
}

void HorusEmulator::PowerCycle(double time_s) {
  Advance(time_s);
  lasers_ = {};
  motor_ = {};
  current_.reset();
  moves_.clear();
  alarm_ = held_ = motion_is_modal_ = in_comment_ = false;
  planned_deg_ = feed_deg_s_ = 0.0;
  line_.clear();
  buffer_.clear();
  block_.reset();
  from_host_.Clear();
  to_host_.Clear();
  boot_until_s_ = now_s_ + options_.boot_time_s;
}

void HorusEmulator::PortOpened(double time_s) { PowerCycle(time_s); }

void HorusEmulator::Receive(std::span<const uint8_t> bytes, double time_s) {
  from_host_.Push(bytes, time_s);
}

std::vector<uint8_t> HorusEmulator::Transmit(double time_s) { return to_host_.PopAll(time_s); }

void HorusEmulator::Advance(double time_s) {
  while (static_cast<double>(ticks_ + 1) * kHorusTick_s <= time_s) Tick();
}

void HorusEmulator::Tick() {
  ++ticks_;
  now_s_ = static_cast<double>(ticks_) * kHorusTick_s;
  if (boot_until_s_) {
    from_host_.PopAll(now_s_);
    if (now_s_ < *boot_until_s_) return;
    boot_until_s_.reset();
    last_message_s_ = now_s_;
    Send(kHorusBanner);
    return;
  }
  StepMotor();
  if (now_s_ - last_message_s_ > options_.laser_timeout_s) lasers_ = {};
  while (const auto byte = from_host_.Pop(now_s_)) {
    last_message_s_ = now_s_;
    if (HandleRealtime(*byte)) continue;
    if (buffer_.size() < kBufferLength) buffer_.push_back(static_cast<char>(*byte));
  }
  while (true) {
    if (block_ && !ExecuteBlock()) break;
    if (buffer_.empty()) break;
    const char c = buffer_.front();
    buffer_.pop_front();
    HandleByte(c);
  }
}

void HorusEmulator::StepMotor() {
  if (!held_ && !current_ && !moves_.empty()) {
    current_ = moves_.front();
    moves_.pop_front();
    motor_.MoveTo(current_->target_deg, current_->feed_deg_s, acceleration_deg_s2_);
  }
  motor_.Step(kHorusTick_s);
  if (current_ && !motor_.moving() && motor_.position() == current_->target_deg) current_.reset();
}

bool HorusEmulator::HandleRealtime(uint8_t byte) {
  switch (byte) {
    case kReset:
      SoftReset();
      return true;
    case '?':
      Send(StatusReport());
      return true;
    case '!':
      held_ = moving();
      if (held_) motor_.RunAt(0.0, acceleration_deg_s2_);
      return true;
    case '~':
      held_ = false;
      if (current_) {
        motor_.MoveTo(current_->target_deg, current_->feed_deg_s, acceleration_deg_s2_);
      }
      return true;
    default:
      return false;
  }
}

void HorusEmulator::SoftReset() {
  const bool aborts_motion = moving();
  motor_.Stop();
  current_.reset();
  moves_.clear();
  planned_deg_ = motor_.position();
  lasers_ = {};
  held_ = in_comment_ = motion_is_modal_ = false;
  feed_deg_s_ = 0.0;
  line_.clear();
  buffer_.clear();
  block_.reset();
  if (aborts_motion) {
    alarm_ = true;
    Send("ALARM: Abort during cycle\r\n");
  }
  Send(kHorusBanner);
  if (alarm_) Send("['$X' to unlock]\r\n");
}

void HorusEmulator::HandleByte(char c) {
  if (c == '\r' || c == '\n') {
    std::string line;
    line.swap(line_);
    in_comment_ = false;
    if (!line.empty()) HandleLine(line);
    return;
  }
  if (in_comment_) {
    in_comment_ = c != ')';
  } else if (c == '(') {
    in_comment_ = true;
  } else if (c <= ' ' || c == '/') {  // blanks, block delete, and all bytes above 0x7f
  } else if (line_.size() >= kLineLength) {
    // What follows of the line is taken for another one, and answered a second time.
    Answer("Line overflow");
    line_.clear();
  } else {
    line_.push_back(c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c);
  }
}

void HorusEmulator::HandleLine(const std::string& line) {
  if (line[0] == '$') {
    Answer(ExecuteSystem(line));
    return;
  }
  if (alarm_) {
    Answer("Alarm lock");
    return;
  }
  HorusBlock block;
  const std::string verdict = ParseHorusBlock(line, motion_is_modal_, &block);
  if (verdict != "ok") {
    Answer(verdict);
    return;
  }
  block_ = block;
}

bool HorusEmulator::ExecuteBlock() {
  const bool waits_for_rest = block_->m_code || block_->sets_zero;
  if (waits_for_rest && moving()) return false;
  if (block_->moves && moves_.size() >= kQueuedMoves) return false;
  const HorusBlock block = *block_;
  block_.reset();

  if (block.feed_deg_s) feed_deg_s_ = *block.feed_deg_s;
  if (block.m_code == 70 || block.m_code == 71) {
    // A laser that does not exist is switched without complaint.
    const auto index = static_cast<size_t>(block.tool) - 1;
    if (index < kLaserCount) lasers_[index] = block.m_code == 71;
  } else if (block.m_code == 50) {
    const auto index = static_cast<size_t>(block.tool) - 1;
    const int counts = index < 2 ? options_.light_sensor_counts[index] : 0;
    Send(std::to_string(counts) + "\r\n");
  }
  if (block.sets_zero) {
    motor_.Redefine(0.0);
    planned_deg_ = 0.0;
  }
  if (block.moves) {
    motion_is_modal_ = true;
    if (block.x_deg && feed_deg_s_ == 0.0) {
      Answer("Undefined feed rate");
      return true;
    }
    if (block.x_deg && *block.x_deg != planned_deg_) {
      moves_.push_back({*block.x_deg, feed_deg_s_});
      planned_deg_ = *block.x_deg;
    }
  }
  Answer("ok");
  return true;
}

std::string HorusEmulator::ExecuteSystem(std::string_view line) {
  if (line == "$") {
    Send(kHelp);
    return "ok";
  }
  if (line == "$$") {
    Send(Format("$120=%.3f (acceleration, deg/sec^2)\r\n", acceleration_deg_s2_));
    return "ok";
  }
  if (line == "$X") {
    if (alarm_) Send("[Caution: Unlocked]\r\n");
    alarm_ = false;
    return "ok";
  }
  return ExecuteSetting(line.substr(1));
}

std::string HorusEmulator::ExecuteSetting(std::string_view assignment) {
  int number = 0;
  const char* const end = assignment.data() + assignment.size();
  const auto name = std::from_chars(assignment.data(), end, number);
  if (name.ec != std::errc()) return "Bad number format";
  if (name.ptr == end || *name.ptr != '=' || number != 120) return "Invalid statement";
  double value = 0.0;
  const auto read = std::from_chars(name.ptr + 1, end, value, std::chars_format::fixed);
  if (read.ec != std::errc() || read.ptr != end) return "Bad number format";
  if (value < 0.0) return "Value < 0";
  if (value == 0.0) return "Invalid statement";
  acceleration_deg_s2_ = value;
  return "ok";
}

std::string HorusEmulator::StatusReport() const {
  const char* const state = alarm_ ? "Alarm" : held_ ? "Hold" : moving() ? "Run" : "Idle";
  return "<" + std::string(state) + Format(",MPos:%.3f", motor_.position()) +
         Format(",WPos:%.3f>\r\n", motor_.position());
}

void HorusEmulator::Answer(const std::string& verdict) {
  Send(verdict == "ok" ? "ok\r\n" : "error: " + verdict + "\r\n");
}

void HorusEmulator::Send(std::string_view text) {
  const auto* bytes = reinterpret_cast<const uint8_t*>(text.data());
  to_host_.Push({bytes, text.size()}, now_s_ + options_.reply_latency_s);
}

}  // namespace geon::sim
