#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "device/ptu_codec.h"
#include "sensor/device_status.h"

namespace geon::device {

struct PtuDriverOptions {
  double poll_period_s = 0.05;
  double reply_timeout_s = 0.5;
  double reset_timeout_s = 40.0;  // both axes hunt for their limits
  double quiet_s = 0.1;           // silence that ends a resynchronisation
  double stall_s = 1.0;           // standing still off the target this long: something is wrong
  double speed_rad_s = 0.9;       // when a command names none; 51.4 deg/s is the unit's own default
  bool reset_at_start = false;    // find the limits anew when the line is opened
};

struct PtuTarget {
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
  double speed_rad_s = 0.0;  // 0: the configured one
  int64_t command_id = 0;
};

struct PtuReport {
  sensor::DeviceStatus status = sensor::DeviceStatus::kUnknown;
  std::string text;     // why, when not ready
  std::string version;  // as the unit says it
  // Angles mean something only when ready.
  int samples = 0;             // complete (pan, tilt) readings since start
  double sample_time_s = 0.0;  // of the newest: when the unit read its counters
  double pan_rad = 0.0, tilt_rad = 0.0;
  double pan_target_rad = 0.0, tilt_target_rad = 0.0;  // clamped to the limits
  double pan_min_rad = 0.0, pan_max_rad = 0.0;
  double tilt_min_rad = 0.0, tilt_max_rad = 0.0;
  bool moving = false;
  int64_t command_id = 0;  // of the newest target that the unit has accepted on both axes
  int limit_hits = 0;      // "!P" and "!T" outside a reset
  int recoveries = 0;      // times the unit had to be initialised again on an open line
};

// Drives a Directed Perception pan-tilt unit. Positive pan looks left, positive tilt looks up.
//
// A state machine without clock and port: the caller reports the line's fate (Connected,
// Disconnected) and calls Step often with the time of a monotonic clock and what arrived; Step
// returns what to send. One command is outstanding, with a deadline; answers are typed and
// range-checked; lines, never byte counts, delimit them. Whatever surprises (no answer, noise, echo
// or sentences of a unit that was power-cycled, a position outside the limits, an answer too many)
// is followed by the same cure: wait for a quiet line, initialise from the start, say the target
// again. A limit mark means that the axis lost its reference: the unit is reset. The blocking
// command A is never used; positions are polled.
class PtuDriver {
 public:
  explicit PtuDriver(const PtuDriverOptions& options = {});
  PtuDriver(const PtuDriver&) = delete;  // requests hold on to their driver
  PtuDriver& operator=(const PtuDriver&) = delete;

  // Where to look from now on, kept through every recovery. Cheap to repeat.
  void SetTarget(const PtuTarget& target);

  void Connected(double time_s);
  void Disconnected(double time_s);
  [[nodiscard]] std::string Step(double time_s, std::string_view bytes_in);

  const PtuReport& report() const { return report_; }

 private:
  enum class Phase { kClosed, kQuiet, kFlush, kInitialising, kRunning };
  struct Axis {
    char letter = 'P';
    double resolution_rad = 0.0;  // per count
    int min_count = 0, max_count = 0;
    int lower_speed = 0, upper_speed = 0;  // counts/s
    int count = 0, last_count = 0;
    double read_s = 0.0, last_read_s = 0.0;  // when the unit read them
    std::optional<int> target_count;  // as accepted by the unit since the last initialisation
    int speed = 0;                    // counts/s, as accepted
  };
  // `accept` takes a kDone answer; false: it does not fit the question.
  struct Request {
    std::string command;
    double timeout_s = 0.0;
    std::function<bool(const PtuLine&)> accept;
    bool may_refuse = false;
    bool may_echo = false;
    bool is_reset = false;
  };
  struct Leniency {
    bool may_refuse = false;
    bool may_echo = false;
  };

  void Receive(double time_s, std::string_view bytes);
  void HandleLine(double time_s, const PtuLine& line);
  void HandleLimits(double time_s);
  void Surprise(double time_s, const std::string& what);
  void Enter(Phase phase, double time_s);
  std::string AdvancePhase(double time_s);
  std::string SendNext(double time_s);

  void QueueInitialisation();
  void QueueAxisQueries(Axis* axis);
  void QueueCount(const std::string& letters, int lowest, int highest, int* count);
  void QueuePlain(const std::string& letters, const Leniency& leniency);
  void QueueReset();
  void QueueTarget();
  void QueuePoll();
  void QueuePosition(const std::string& letters, Axis* axis);
  void TakeSample(double time_s);
  double CountAt(const Axis& axis, double time_s) const;
  int TargetCount(const Axis& axis, double angle_rad) const;
  int SpeedCount(const Axis& axis, double speed_rad_s) const;

  PtuDriverOptions options_;
  PtuReport report_;
  PtuReader reader_;
  Phase phase_ = Phase::kClosed;
  std::deque<Request> queue_;
  bool outstanding_ = false;  // the front of the queue has been sent
  double sent_s_ = 0.0;       // when
  double deadline_s_ = 0.0;
  double phase_since_s_ = 0.0;
  double last_byte_s_ = 0.0;
  double next_poll_s_ = 0.0;
  double still_since_s_ = 0.0;
  double now_s_ = 0.0;
  Axis pan_;
  Axis tilt_;
  std::optional<PtuTarget> target_;
  bool reset_wanted_ = false;
  bool stalled_ = false;
  int stalls_ = 0;
  int failures_ = 0;  // in a row
};

}  // namespace geon::device
