#pragma once

#include <cstdint>

#include "sensor/device_status.h"

namespace geon::sensor {

// Where the pan-tilt unit is. Radians; positive pan looks left, positive tilt looks up.
struct PtuState {
  int64_t utime = 0;
  int32_t seq = 0;
  DeviceStatus status = DeviceStatus::kUnknown;
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
  double pan_target_rad = 0.0;
  double tilt_target_rad = 0.0;
  double pan_min_rad = 0.0, pan_max_rad = 0.0;
  double tilt_min_rad = 0.0, tilt_max_rad = 0.0;
  bool moving = false;
  int64_t command_id = 0;  // of the newest command that was obeyed (0: none since start)
};

// Desired state of the head; re-sent until PtuState echoes command_id and stands still.
struct PtuCommand {
  int64_t utime = 0;
  int32_t seq = 0;
  int64_t command_id = 0;
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
  double speed_rad_s = 0.0;  // 0: the configured default
};

}  // namespace geon::sensor
