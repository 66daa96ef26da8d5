#pragma once

#include <cstdint>

#include "sensor/device_status.h"
#include "sensor/stripe.h"

namespace geon::sensor {

// What is known of the two line lasers. `laser` is the one that burns or, while its board is being
// recovered, the one that may burn. Both are dark only when it is kNone and the status is kReady.
struct LaserState {
  int64_t utime = 0;
  int32_t seq = 0;
  DeviceStatus status = DeviceStatus::kUnknown;
  Laser laser = Laser::kNone;
  double on_time_s = 0.0;  // since start, both lasers
};

}  // namespace geon::sensor
