#include "sim/nomad_state.h"

#include <algorithm>
#include <cmath>

#include "sim/nomad_frames.h"

namespace geon::sim {

void AppendNomadInfrared(const NomadState& state, uint16_t mask, std::vector<uint8_t>* payload) {
  bool half = false;
  for (size_t i = 0; i < state.infrared.size(); ++i) {
    if ((mask >> i & 1) == 0) continue;
    const unsigned nibble = state.infrared[i] & 0x0fu;
    if (half) {
      payload->back() = static_cast<uint8_t>(payload->back() | (nibble << 4));
    } else {
      payload->push_back(static_cast<uint8_t>(nibble));
    }
    half = !half;
  }
}

void AppendNomadBumpers(const NomadState& state, std::vector<uint8_t>* payload) {
  for (const int shift : {16, 8, 0}) {
    payload->push_back(static_cast<uint8_t>((state.bumpers >> shift) & 0xff));
  }
}

std::vector<uint8_t> EncodeNomadState(const NomadState& state, const NomadMask& mask) {
  std::vector<uint8_t> payload;
  AppendNomadInfrared(state, static_cast<uint16_t>(mask[0] | (mask[1] << 8)), &payload);
  const unsigned sonars = mask[2] | (static_cast<unsigned>(mask[3]) << 8);
  for (size_t i = 0; i < state.sonar_in.size(); ++i) {
    if ((sonars >> i & 1) != 0) payload.push_back(state.sonar_in[i]);
  }
  if ((mask[4] & 1) != 0) AppendNomadBumpers(state, &payload);
  for (size_t i = 0; i < state.configuration.size(); ++i) {
    if ((mask[4] >> (1 + i) & 1) != 0) AppendNomadSigned(state.configuration[i], &payload);
  }
  for (size_t i = 0; i < state.velocity.size(); ++i) {
    if ((mask[4] >> (5 + i) & 1) != 0) AppendNomadSigned(state.velocity[i], &payload);
  }
  if ((mask[6] & 1) != 0) AppendNomadSigned(state.compass, &payload);
  if ((mask[5] & 1) != 0) AppendNomadUnsigned(0, &payload);  // laser: no points
  payload.push_back(state.motors_active);
  AppendNomadUnsigned32(state.time_ms, &payload);
  payload.push_back(state.cpu_volts_raw);
  payload.push_back(state.motor_volts_raw);
  return payload;
}

uint8_t NomadRawVolts(double voltage_V, double full_scale_V) {
  const double raw = (5.0 * voltage_V / full_scale_V - 2.0) * 255.0 / 3.0;
  return static_cast<uint8_t>(std::clamp(std::lround(raw), 0L, 255L));
}

}  // namespace geon::sim
