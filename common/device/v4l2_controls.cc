#include "device/v4l2_controls.h"

#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>

namespace geon::device {
namespace {

int32_t PowerLineMenu(int hz) {
  if (hz == 50) return V4L2_CID_POWER_LINE_FREQUENCY_50HZ;
  if (hz == 60) return V4L2_CID_POWER_LINE_FREQUENCY_60HZ;
  return V4L2_CID_POWER_LINE_FREQUENCY_DISABLED;
}

std::string Named(const ControlSetting& setting, int32_t value) {
  return std::string(setting.name) + " = " + std::to_string(value);
}

v4l2_ext_controls Only(v4l2_ext_control* control) {
  v4l2_ext_controls controls{};
  controls.which = V4L2_CTRL_WHICH_CUR_VAL;
  controls.count = 1;
  controls.controls = control;
  return controls;
}

Status ApplyControl(const ControlSetting& setting, const Ioctl& device_ioctl) {
  v4l2_ext_control control{};
  control.id = setting.id;
  control.value = setting.value;
  v4l2_ext_controls controls = Only(&control);
  if (device_ioctl(VIDIOC_S_EXT_CTRLS, &controls) != 0) {
    if (!setting.required) return Status::Ok();
    return Status::Error("the camera refuses " + Named(setting, setting.value) + ": " +
                         std::strerror(errno));
  }
  control.value = 0;
  if (device_ioctl(VIDIOC_G_EXT_CTRLS, &controls) != 0) {
    return Status::Error("the camera does not read back " + std::string(setting.name) + ": " +
                         std::strerror(errno));
  }
  if (control.value != setting.value) {
    return Status::Error("the camera has " + Named(setting, control.value) + ", not the " +
                         std::to_string(setting.value) + " written");
  }
  return Status::Ok();
}

class DeviceFile {
 public:
  explicit DeviceFile(const std::string& device)
      : fd_(open(device.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC)) {}
  ~DeviceFile() {
    if (is_open()) close(fd_);
  }
  DeviceFile(const DeviceFile&) = delete;
  DeviceFile& operator=(const DeviceFile&) = delete;
  bool is_open() const { return fd_ >= 0; }
  Ioctl ioctl() const {
    return [fd = fd_](unsigned long request, void* argument) {
      return ::ioctl(fd, request, argument);
    };
  }

 private:
  int fd_;
};

}  // namespace

std::vector<ControlSetting> ControlSettings(const CameraControls& controls) {
  std::vector<ControlSetting> settings;
  if (controls.exposure_s) {
    const auto exposure_100us = static_cast<int32_t>(std::lround(*controls.exposure_s * 1e4));
    settings.push_back(
        {V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL, "auto exposure (1: manual)", true});
    settings.push_back(
        {V4L2_CID_EXPOSURE_AUTO_PRIORITY, 0, "exposure may change the frame rate", false});
    settings.push_back({V4L2_CID_EXPOSURE_ABSOLUTE, exposure_100us, "exposure (100 us)", true});
  }
  if (controls.gain) {
    settings.push_back({V4L2_CID_AUTOGAIN, 0, "auto gain", false});
    settings.push_back({V4L2_CID_GAIN, *controls.gain, "gain", true});
  }
  if (controls.white_balance_k) {
    settings.push_back({V4L2_CID_AUTO_WHITE_BALANCE, 0, "auto white balance", true});
    settings.push_back(
        {V4L2_CID_WHITE_BALANCE_TEMPERATURE, *controls.white_balance_k, "white balance (K)", true});
  }
  if (controls.power_line_hz) {
    settings.push_back({V4L2_CID_POWER_LINE_FREQUENCY, PowerLineMenu(*controls.power_line_hz),
                        "power line frequency (menu)", true});
  }
  if (!settings.empty()) {
    settings.push_back({V4L2_CID_FOCUS_AUTO, 0, "auto focus", false});
    settings.push_back({V4L2_CID_BACKLIGHT_COMPENSATION, 0, "backlight compensation", false});
  }
  return settings;
}

Status ApplyControls(const std::vector<ControlSetting>& settings, const Ioctl& device_ioctl) {
  std::string refused;
  for (const ControlSetting& setting : settings) {
    const Status status = ApplyControl(setting, device_ioctl);
    if (!status.ok()) refused += (refused.empty() ? "" : "; ") + status.message();
  }
  return refused.empty() ? Status::Ok() : Status::Error(refused);
}

Status ApplyControls(const CameraControls& controls, const std::string& device) {
  const DeviceFile file(device);
  if (!file.is_open()) return Status::Error(device + ": " + std::strerror(errno));
  return ApplyControls(ControlSettings(controls), file.ioctl()).In(device);
}

std::optional<double> ReadExposure(const Ioctl& device_ioctl) {
  v4l2_ext_control control{};
  control.id = V4L2_CID_EXPOSURE_ABSOLUTE;
  v4l2_ext_controls controls = Only(&control);
  if (device_ioctl(VIDIOC_G_EXT_CTRLS, &controls) != 0 || control.value <= 0) return std::nullopt;
  return 1e-4 * control.value;
}

std::optional<double> ReadExposure(const std::string& device) {
  const DeviceFile file(device);
  return file.is_open() ? ReadExposure(file.ioctl()) : std::nullopt;
}

}  // namespace geon::device
