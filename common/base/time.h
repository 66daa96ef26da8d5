#pragma once

#include <cstdint>

namespace geon {

// Instants are `int64_t utime`: microseconds since the Unix epoch, taken at acquisition, on the
// clock of the host that acquired. Two hosts' utimes are never compared (architecture: the robot
// and the workstation share no clock). Durations in interfaces are seconds, suffix _s.
constexpr double SecondsFromMicroseconds(int64_t duration_us) {
  return static_cast<double>(duration_us) * 1e-6;
}
constexpr int64_t MicrosecondsFromSeconds(double duration_s) {
  return static_cast<int64_t>(duration_s * 1e6 + (duration_s < 0 ? -0.5 : 0.5));
}

}  // namespace geon
