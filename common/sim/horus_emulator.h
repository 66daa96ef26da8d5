#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/horus_gcode.h"
#include "sim/paced_bytes.h"
#include "sim/serial_device.h"
#include "sim/trapezoid_axis.h"

namespace geon::sim {

struct HorusEmulatorOptions {
  int baud = 115200;
  double boot_time_s = 0.5;  // from reboot to banner; what comes in meanwhile is lost
  double reply_latency_s = 0.001;
  double laser_timeout_s = 255.0;                   // lasers go off after so long without a message
  std::array<int, 2> light_sensor_counts = {0, 0};  // what M50T1 and M50T2 read
};

// The Horus (Ciclop) board that switches the line lasers: G-code of hardware card 3.1 with the
// quirks seen on the real firmware. Laser T1 draws the horizontal stripe, T2 the vertical one.
//
// Switching a laser waits for the turntable's queued moves, and with it every line behind; only
// "?", "!", "~" and Ctrl-X are heard at once.
class HorusEmulator : public SerialDevice {
 public:
  static constexpr size_t kLaserCount = 4;

  explicit HorusEmulator(const HorusEmulatorOptions& options = {});

  int baud() const override { return options_.baud; }
  void Receive(std::span<const uint8_t> bytes, double time_s) override;
  void Advance(double time_s) override;
  std::vector<uint8_t> Transmit(double time_s) override;
  void PowerCycle(double time_s) override;
  void PortOpened(double time_s) override;  // DTR reboots the board

  // The truth: which lasers burn now; index 0 is T1.
  const std::array<bool, kLaserCount>& lasers() const { return lasers_; }

 private:
  struct Move {
    double target_deg;
    double feed_deg_s;
  };

  void Tick();
  void SoftReset();
  bool HandleRealtime(uint8_t byte);
  void HandleByte(char c);
  void HandleLine(const std::string& line);
  // Executes the blocked line as far as it can: false while it still waits for the turntable.
  bool ExecuteBlock();
  std::string ExecuteSystem(std::string_view line);
  std::string ExecuteSetting(std::string_view assignment);
  void StepMotor();
  bool moving() const { return current_.has_value() || !moves_.empty(); }
  std::string StatusReport() const;
  void Answer(const std::string& verdict);
  void Send(std::string_view text);

  HorusEmulatorOptions options_;
  std::array<bool, kLaserCount> lasers_{};
  TrapezoidAxis motor_;  // degrees
  std::optional<Move> current_;
  std::deque<Move> moves_;
  double planned_deg_ = 0.0;  // where the last queued move ends
  double feed_deg_s_ = 0.0;
  double acceleration_deg_s2_ = 300.0;  // $120, kept without power
  bool motion_is_modal_ = false;
  bool held_ = false;
  bool alarm_ = false;
  std::string line_;
  bool in_comment_ = false;
  std::deque<char> buffer_;          // received, not yet read
  std::optional<HorusBlock> block_;  // the line being executed
  std::optional<double> boot_until_s_;
  double last_message_s_ = 0.0;
  int64_t ticks_ = 0;
  double now_s_ = 0.0;
  PacedBytes from_host_;
  PacedBytes to_host_;
};

}  // namespace geon::sim
