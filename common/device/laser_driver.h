#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/status.h"
#include "device/horus_codec.h"
#include "device/serial_link.h"
#include "sensor/device_status.h"
#include "sensor/stripe.h"

namespace geon::device {

struct LaserDriverOptions {
  double reply_timeout_s = 0.5;  // for one "ok"
  double start_timeout_s = 2.5;  // from Ctrl-X to the banner: the boot loader takes its time
  double quiet_s = 0.1;          // silence that ends a resynchronisation
  double refresh_period_s =
      1.0;  // the wanted state is said again: notices a dead or restarted board,
            // and keeps the firmware's 255 s time-out away from a lit laser
};

struct LaserReport {
  sensor::DeviceStatus status = sensor::DeviceStatus::kUnknown;
  std::string text;  // why, when not ready
  // The one that burns, or may burn because its last command was not confirmed.
  sensor::Laser laser = sensor::Laser::kNone;
  // True when the board has confirmed that exactly `laser` burns and the other (or both) is dark,
  // in the present state of things; then confirmed_time_s is when the last "ok" of the change
  // arrived.
  bool confirmed = false;
  double confirmed_time_s = 0.0;
  double on_time_s = 0.0;  // since start
  int restarts = 0;  // times the board restarted by itself: frames taken across one are worthless
  int errors = 0;    // missing, refused or foreign answers since start
};

// Drives the two line lasers through a Horus board: laser 1 is horizontal, 2 vertical.
//
// A state machine without clock and port: the caller reports the line's fate (Connected,
// Disconnected) and calls Step often with the time of a monotonic clock and what arrived; Step
// returns what to send. One command is outstanding at a time, each with a deadline. After any
// surprise (no answer, error, noise, an answer too many) both lasers count as unknown until
// switched off and confirmed again.
//
// Never both on: a laser is switched on only when the other has been confirmed off since. A line
// that comes back starts with everything off and nothing wanted.
class LaserDriver {
 public:
  explicit LaserDriver(const LaserDriverOptions& options = {});

  // What shall burn from now on. Cheap to repeat.
  void Request(sensor::Laser laser) { wanted_ = laser; }

  void Connected(double time_s);
  void Disconnected(double time_s);
  [[nodiscard]] std::string Step(double time_s, std::string_view bytes_in);

  const LaserReport& report() const { return report_; }

 private:
  enum class Phase { kClosed, kQuiet, kStarting, kRunning };
  enum class Lamp { kUnknown, kOff, kOn };
  struct Outstanding {
    int laser = 0;  // 0-based
    bool on = false;
    double deadline_s = 0.0;
  };

  void Receive(double time_s, std::string_view bytes);
  void HandleLine(double time_s, const HorusLine& line);
  void Confirm(double time_s);
  void Restarted(double time_s);
  void Surprise(double time_s, const std::string& what);
  std::string NextCommand(double time_s);
  std::string Send(double time_s, int laser, bool on);
  void LoseStep(double time_s);
  void UpdateReport();

  LaserDriverOptions options_;
  LaserReport report_;
  HorusReader reader_;
  Phase phase_ = Phase::kClosed;
  sensor::Laser wanted_ = sensor::Laser::kNone;
  std::array<Lamp, 2> lamps_{Lamp::kUnknown, Lamp::kUnknown};
  std::optional<Outstanding> outstanding_;
  double phase_since_s_ = 0.0;
  double last_byte_s_ = 0.0;
  double last_refresh_s_ = 0.0;
  double last_step_s_ = 0.0;
  int refreshed_ = 0;  // which lamp's state was said last
  int failures_ = 0;   // in a row
  // Said to burn and not confirmed dark since.
  sensor::Laser may_burn_ = sensor::Laser::kNone;
  bool in_step_ = false;
  bool foreign_ = false;  // another firmware answered last
  bool restart_expected_ = false;
};

// For every way out of a program: says "off" to both lasers and waits at most `patience_s` for both
// "ok". Blocks; opens nothing. Error: not confirmed.
Status SwitchOffNow(SerialLink* link, double patience_s = 0.5);

}  // namespace geon::device
