#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace geon::device {

// What must stand still for a camera to measure: every automatism off. Unset: left alone.
struct CameraControls {
  std::optional<double> exposure_s;
  std::optional<int> gain;
  std::optional<int> white_balance_k;
  std::optional<int> power_line_hz;  // 0 (off), 50 or 60: exposures in step with the room's light
};

// One control to write, by V4L2 id: names changed between kernels, ids did not.
struct ControlSetting {
  uint32_t id = 0;
  int32_t value = 0;
  std::string_view name;
  bool required = false;  // else a camera without it is fine
};

// What to write, in the order that works: an automatism off before its value.
std::vector<ControlSetting> ControlSettings(const CameraControls& controls);

// ioctl(2) on the device: request and argument, 0 or -1 with errno.
using Ioctl = std::function<int(unsigned long request, void* argument)>;

// Writes each control and reads it back. Error: all that are missing, refused or not what was
// written; the others are written all the same.
Status ApplyControls(const std::vector<ControlSetting>& settings, const Ioctl& device_ioctl);
// The same on a device file.
Status ApplyControls(const CameraControls& controls, const std::string& device);

// The exposure as the camera has it; nothing when it does not say.
std::optional<double> ReadExposure(const Ioctl& device_ioctl);
std::optional<double> ReadExposure(const std::string& device);

}  // namespace geon::device
