#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
class HorusEmulator : public SerialDevice {
 public:
  static constexpr int kLaserCount = 4;

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
  struct Block;  // the words of one line of G-code

  void Tick();
  void Reboot(double time_s);
  void SoftReset();
  void HandleByte(uint8_t byte);
  bool HandleRealtime(uint8_t byte);
  void HandleLine(const std::string& line);
  std::string ExecuteSystem(std::string_view line);  // a "$" line; returns ok or error text
  std::string ExecuteSetting(std::string_view assignment);
  std::string ExecuteBlock(const Block& block);
  std::string ParseBlock(std::string_view line, Block* block) const;  // "ok" or why not
  std::string StatusReport() const;
  void Send(std::string_view text);
  bool moving() const { return motor_.moving(); }

  HorusEmulatorOptions options_;
  std::array<bool, kLaserCount> lasers_{};
  TrapezoidAxis motor_;  // degrees
  bool motor_powered_ = false;
  bool held_ = false;
  double feed_deg_s_ = 0.0;
  double acceleration_deg_s2_ = 300.0;
  std::string line_;
  bool in_comment_ = false;
  std::optional<std::string> blocked_line_;  // a laser command behind a motion
  std::optional<double> boot_until_s_;
  double last_message_s_ = 0.0;
  int64_t ticks_ = 0;
  double now_s_ = 0.0;
  PacedBytes from_host_;
  PacedBytes to_host_;
};

}  // namespace geon::sim
