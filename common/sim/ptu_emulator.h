#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/paced_bytes.h"
#include "sim/ptu_axis.h"
#include "sim/serial_device.h"

namespace geon::sim {

struct PtuEmulatorOptions {
  int baud = 9600;
  double resolution_arcsec = 185.1428;             // of one count, both axes
  double pan_minimum = -3090, pan_maximum = 3090;  // counts, found at reset
  double tilt_minimum = -907, tilt_maximum = 604;
  double stop_margin = 30;            // counts from a bound to the hard stop
  double highest_upper_speed = 5833;  // counts/s: the data sheet's 300 deg/s
  double reset_speed = 1500;          // counts/s while hunting for the stops
  double table_time_s = 1.0;          // to recompute the speed tables (xA, xB, xL, lowering xU)
  double upper_speed_time_s = 6.0;    // to raise xU
  double reply_latency_s = 0.002;
  bool reset_ends_with_newline = true;  // some firmware sends the reset's last star bare
  // Whether the unit still has its power-up reset ahead when the world begins.
  bool starts_with_reset = false;
};

// The Directed Perception PTU-46 at the end of its serial line: the ASCII command set of hardware
// card 1, with real motion. Positive pan turns left, positive tilt looks up.
//
// Left out: the binary command set, whose opcodes are not published, and the E series' additions.
class PtuEmulator : public SerialDevice {
 public:
  explicit PtuEmulator(const PtuEmulatorOptions& options = {});

  int baud() const override { return options_.baud; }
  void Receive(std::span<const uint8_t> bytes, double time_s) override;
  void Advance(double time_s) override;
  std::vector<uint8_t> Transmit(double time_s) override;
  void PowerCycle(double time_s) override;

  // Something catches the head: the axis loses steps and reports it (!P or !T).
  void StallPan(double counts) { pan_.LoseSteps(counts); }
  void StallTilt(double counts) { tilt_.LoseSteps(counts); }

  // The truth: where the head really points, and whether it moves.
  double pan_rad() const;
  double tilt_rad() const;
  bool moving() const { return pan_.moving() || tilt_.moving(); }

 private:
  struct Command;  // letters and argument of one received word
  enum class ResetStep { kNone, kTiltDown, kTiltUp, kPanRight, kPanLeft, kHome };
  // What DS saves and DR restores.
  struct Settings {
    PtuAxisSettings pan, tilt;
    bool limits = true;
    bool immediate = true;
    bool velocity_mode = false;
    bool monitor_at_power_up = false;
    bool reset_pan_at_power_up = true;
    bool reset_tilt_at_power_up = true;
    int unit_id = 0;
  };
  struct Monitor {
    double pan_a = -2000, pan_b = 2000, tilt_a = 0, tilt_b = 0;
    bool running = false;
    bool towards_b = false;
  };

  void Tick();
  void HandleByte(uint8_t byte);
  void HandleWord(std::string word);
  std::string Execute(const Command& command);  // the reply without star, or "! why"
  std::string ExecuteGeneral(const Command& command);
  std::string ExecuteModes(const Command& command);
  std::string ExecuteAxis(const Command& command);
  std::string AxisQuery(const Command& command);
  std::string SetPosition(const Command& command);
  std::string SetSpeed(const Command& command);
  std::string SetTable(const Command& command);
  std::string ExecutePower(const Command& command);
  std::string ExecuteMonitor(const Command& command);
  std::string ExecuteNetwork(const Command& command);
  std::string ExecuteSettings(const Command& command);

  PtuAxis& AxisOf(const Command& command);
  void StartPendingMoves();
  void StopMonitorAndGoHome();
  void StartReset(bool tilt, bool pan);
  void StepReset();
  void EnterResetStep(ResetStep step);
  void StepMonitor();
  void Reply(const std::string& result);
  void Send(std::string_view text);
  bool busy() const;

  PtuEmulatorOptions options_;
  PtuAxis pan_;
  PtuAxis tilt_;
  Settings saved_;
  Settings settings_;
  Monitor monitor_;
  bool echo_ = true;
  bool verbose_ = true;
  bool selected_ = true;
  std::string word_;
  std::string muted_;  // replies of a unit that is not selected
  std::optional<double> pending_pan_, pending_tilt_;
  bool awaiting_ = false;                // A: replies when both axes have arrived
  std::optional<double> table_until_s_;  // recomputing tables: deaf until then
  ResetStep reset_ = ResetStep::kNone;
  bool resets_pan_ = false;
  bool announces_reset_ =
      false;  // a reset asked for by R ends with a star, one at power-up with the banner
  int64_t ticks_ = 0;
  double now_s_ = 0.0;
  PacedBytes from_host_;
  PacedBytes to_host_;
};

}  // namespace geon::sim
