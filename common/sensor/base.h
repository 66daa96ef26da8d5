#pragma once

#include <array>
#include <cstdint>

#include "sensor/device_status.h"

namespace geon::sensor {

inline constexpr int kSonarCount = 16;
inline constexpr int kInfraredCount = 16;
inline constexpr int kBumperCount = 20;

// Why the base does not do what was asked.
enum class BaseStop {
  kNone = 0,
  kBumper = 1,          // a bumper is pressed or was within the latch time
  kCommandExpired = 2,  // no fresh command
  kStaleCommand = 3,    // the command answers a base state that is too old
  kDeviceLost = 4,      // the serial line is being recovered
  kLaserOn = 5,         // a laser burns: the base does not drive
};

// Odometry and drive state of the robot. W is where odometry started (x forward at start).
struct BaseState {
  int64_t utime = 0;
  int32_t seq = 0;
  DeviceStatus status = DeviceStatus::kUnknown;
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;  // of the steering and of the turret, which follows it
  double speed_m_s = 0.0;
  double turn_rate_rad_s = 0.0;
  bool moving = false;
  BaseStop stop = BaseStop::kNone;
  int64_t command_id = 0;  // of the newest command accepted
};

// Desired velocities. Re-sent at 20 Hz; expires 0.15 s after arrival, and is refused when the
// BaseState it answers (`state_seq`) is older than 0.3 s by the base's own clock: no shared clock
// is needed.
struct BaseCommand {
  int64_t utime = 0;
  int32_t seq = 0;
  int64_t command_id = 0;
  int32_t state_seq = 0;
  double speed_m_s = 0.0;
  double turn_rate_rad_s = 0.0;
};

// One state of the sonar ring, with the odometry that belongs to it. Sensor i looks at
// heading + i * 22.5 degrees, counter-clockwise, from 0.225 m off the axis. NaN: no echo.
struct SonarScan {
  int64_t utime = 0;
  int32_t seq = 0;
  double x_m = 0.0, y_m = 0.0, heading_rad = 0.0;
  std::array<double, kSonarCount> range_m{};
};

// Bumper i sits at i * 18 degrees on the base, which does not turn with the steering;
// bearing_rad[i] is its bearing in R at this moment.
struct BumperState {
  int64_t utime = 0;
  int32_t seq = 0;
  std::array<bool, kBumperCount> pressed{};
  std::array<double, kBumperCount> bearing_rad{};
  int32_t contact_count = 0;  // times any bumper went from free to pressed since start
};

// Infrared proximity, sensor i at heading + i * 22.5 degrees; 0 nothing ... 15 touching.
struct InfraredScan {
  int64_t utime = 0;
  int32_t seq = 0;
  std::array<int, kInfraredCount> level{};
};

}  // namespace geon::sensor
