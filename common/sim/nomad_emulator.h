#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/bumper_ring.h"
#include "sim/infrared_ring.h"
#include "sim/nomad_frames.h"
#include "sim/nomad_state.h"
#include "sim/paced_bytes.h"
#include "sim/serial_device.h"
#include "sim/sonar_ring.h"
#include "sim/synchro_drive.h"

namespace geon::sim {

struct NomadEmulatorOptions {
  int baud = 38400;
  uint64_t seed = 1;
  SynchroDriveOptions drive;
  SonarRingOptions sonar;
  BumperRingOptions bumpers;
  InfraredRingOptions infrared;
  // The turret goes with the steering unless a command names a turret motion of its own.
  bool turret_follows_steering = true;
  double reply_latency_s = 0.003;
  double byte_timeout_s = 0.1;  // a frame with a longer gap in it is forgotten
  double cpu_battery_V = 11.4;
  double motor_battery_V = 12.1;
};

// The Nomad 200 base at the end of its direct serial line: frames of hardware card 2, one reply for
// each command, sonar, bumpers, infrared and odometry of a body that moves in `surroundings`.
//
// Left out: torque control (MV modes 7 and 8), SPECIAL, CONF_SER (not on this model) and the
// position attachments of the state packet, whose layout depends on the host's compiler: the first
// two are answered with NAK, the attachments' mask bits are ignored. No laser ranger is fitted.
class NomadEmulator : public SerialDevice {
 public:
  // `surroundings` outlives the emulator.
  NomadEmulator(const NomadEmulatorOptions& options, const Surroundings* surroundings);

  int baud() const override { return options_.baud; }
  void Receive(std::span<const uint8_t> bytes, double time_s) override;
  void Advance(double time_s) override;
  std::vector<uint8_t> Transmit(double time_s) override;
  void PowerCycle(double time_s) override;

  // The truth: the body in the world (pose, speed, contacts).
  const SynchroDrive& drive() const { return drive_; }
  bool bumper_pressed() const { return bumpers_.any_pressed(); }

 private:
  enum class Waiting { kNone, kStopped, kZeroed };
  // How MV drives one servo.
  enum class ServoMode { kIgnore, kVelocity, kRelative, kLimp, kAcceleration, kSpeed, kAbsolute };

  void Tick();
  void HandleFrame(const NomadFrame& frame);
  // The reply to a command; nothing when it comes later (WS, ZR), NAK when it cannot be done.
  std::optional<NomadFrame> Execute(const NomadFrame& frame);
  std::optional<NomadFrame> ExecuteMotion(const NomadFrame& frame);
  std::optional<NomadFrame> ExecuteConfiguration(const NomadFrame& frame);
  std::optional<NomadFrame> ExecuteQuery(const NomadFrame& frame) const;
  // Whether the turret is to go with the steering, for these raw values of the two.
  void TieTurretFor(int steering, int turret);
  void MoveServos(const std::vector<uint8_t>& payload);
  void MoveServo(Servo servo, ServoMode mode, double value);
  void StartZeroing();
  void StartWaiting(const NomadFrame& frame);
  void StepWaiting();
  void StopAll();
  NomadFrame StateReply(uint8_t type) const;
  NomadState Measure() const;
  void EndWaiting();
  void Send(const NomadFrame& frame);

  NomadEmulatorOptions options_;
  SynchroDrive drive_;
  SonarRing sonar_;
  BumperRing bumpers_;
  InfraredRing infrared_;
  NomadFrameReader reader_;
  NomadMask mask_{};
  bool compass_on_ = true;
  double dead_man_s_ = 0.0;  // 0: never
  double last_command_s_ = 0.0;
  double last_byte_s_ = 0.0;
  Waiting waiting_ = Waiting::kNone;
  uint8_t waiting_type_ = 0;
  std::array<bool, 3> waits_for_{};
  double wait_until_s_ = 0.0;
  int64_t ticks_ = 0;
  double now_s_ = 0.0;
  double power_up_s_ = 0.0;
  PacedBytes from_host_;
  PacedBytes to_host_;
};

}  // namespace geon::sim
