#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/paced_bytes.h"
#include "sim/ptu_commands.h"
#include "sim/ptu_unit.h"
#include "sim/serial_device.h"

namespace geon::sim {

struct PtuEmulatorOptions {
  int baud = 9600;
  PtuUnitOptions unit;
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
  void StallPan(double counts) { unit_.axis(PtuAxisId::kPan).LoseSteps(counts); }
  void StallTilt(double counts) { unit_.axis(PtuAxisId::kTilt).LoseSteps(counts); }

  // The truth: where the head really points, and whether it moves.
  double pan_rad() const { return unit_.shaft_rad(PtuAxisId::kPan); }
  double tilt_rad() const { return unit_.shaft_rad(PtuAxisId::kTilt); }
  bool moving() const { return unit_.moving(); }

 private:
  void Tick();
  void HandleByte(uint8_t byte);
  void HandleWord(const std::string& word);
  void SelectUnit(int id);
  void Answer(const PtuReply& reply);
  void FinishPending();
  // To the host, or kept for later by a unit that is not selected.
  void Send(std::string_view text);

  PtuEmulatorOptions options_;
  PtuUnit unit_;
  bool selected_ = true;
  std::string word_;
  std::string muted_;
  // A command whose answer comes later; the unit hears nothing until then.
  std::optional<PtuReply> pending_;
  std::optional<double> tables_ready_s_;
  bool powering_up_ = false;
  int64_t ticks_ = 0;
  double now_s_ = 0.0;
  PacedBytes from_host_;
  PacedBytes to_host_;
};

}  // namespace geon::sim
