#pragma once

#include <cstdint>
#include <string>

#include "sensor/device_status.h"

namespace geon::sensor {

enum class HealthLevel { kStarting = 0, kOk = 1, kWarn = 2, kFault = 3 };

// The level of a process whose work is this device.
constexpr HealthLevel LevelOf(DeviceStatus device) {
  switch (device) {
    case DeviceStatus::kReady:
      return HealthLevel::kOk;
    case DeviceStatus::kStarting:
      return HealthLevel::kStarting;
    case DeviceStatus::kUnknown:
    case DeviceStatus::kFault:
      return HealthLevel::kFault;
  }
  return HealthLevel::kFault;
}

// How one process is, once a second: a level, not an edge, so that who joins late sees it.
struct Health {
  int64_t utime = 0;
  int32_t seq = 0;
  std::string process;
  std::string host;
  int32_t pid = 0;
  std::string version;
  std::string config_hash;
  HealthLevel level = HealthLevel::kStarting;
  std::string text;  // why, when not kOk
  double uptime_s = 0.0;
  double loop_hz = 0.0;
  int64_t rx_lost = 0;        // messages missed by seq, all channels
  int64_t decode_errors = 0;  // messages refused
  double max_age_s = 0.0;     // oldest input used in the last second, stamp to use; one host only
  double cpu_s = 0.0;         // processor time since start
  int64_t rss_bytes = 0;
  int32_t reconnects = 0;  // of the device, since start
};

// Who ran with what: makes any piece of a log self-describing.
struct Session {
  int64_t utime = 0;
  int32_t seq = 0;
  std::string process;
  std::string host;
  int64_t start_utime = 0;
  std::string version;           // git describe
  std::string config_hash;       // of the robot file
  std::string calibration_hash;  // of the look-up tables or the calibrated rig in use, else empty
  std::string calibration_file;
  int64_t types_hash = 0;  // sum of all fingerprints
};

}  // namespace geon::sensor
