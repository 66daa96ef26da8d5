#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace geon::sim {

// What the robot says of itself, in the units of its wire: tenths of inches, of degrees, of inches
// and degrees per second.
struct NomadState {
  std::array<uint8_t, 16> infrared{};
  std::array<uint8_t, 16> sonar_in{};
  uint32_t bumpers = 0;                // bit i is bumper i
  std::array<int, 4> configuration{};  // x, y, steering, turret
  std::array<int, 3> velocity{};       // translation, steering, turret
  int compass = 0;
  uint8_t motors_active = 0;  // bit 0 translation, 1 steering, 2 turret
  uint32_t time_ms = 0;       // of the 16.4 ms clock since switched on
  uint8_t cpu_volts_raw = 0;
  uint8_t motor_volts_raw = 0;
};

// What the state packet holds, as CT sets it: {infrared 0-7, 8-15, sonar 0-7, 8-15,
// {bumpers, x, y, steering, turret, three velocities}, laser, compass}.
using NomadMask = std::array<uint8_t, 7>;

// The payload of a state packet: the fields whose mask bit is set, then those always sent.
std::vector<uint8_t> EncodeNomadState(const NomadState& state, const NomadMask& mask);

// The pieces that GET_* replies are made of.
void AppendNomadInfrared(const NomadState& state, uint16_t mask, std::vector<uint8_t>* payload);
void AppendNomadBumpers(const NomadState& state, std::vector<uint8_t>* payload);

// The battery reading of the robot's converter: V = (2 + 3 raw / 255) * full_scale_V / 5.
uint8_t NomadRawVolts(double voltage_V, double full_scale_V);

}  // namespace geon::sim
