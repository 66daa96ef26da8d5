#include "device/v4l2_controls.h"

#include <gtest/gtest.h>
#include <linux/videodev2.h>

#include <cerrno>
#include <map>
#include <vector>

namespace geon::device {
namespace {

// A camera that has some controls, keeps what is written (within a limit) and remembers the order.
class FakeCamera {
 public:
  Ioctl ioctl() {
    return [this](unsigned long request, void* argument) {
      auto* controls = static_cast<v4l2_ext_controls*>(argument);
      v4l2_ext_control& control = controls->controls[0];
      const auto it = values.find(control.id);
      if (it == values.end()) {
        errno = EINVAL;
        return -1;
      }
      if (request == VIDIOC_S_EXT_CTRLS) {
        written.push_back(control.id);
        it->second = std::min(control.value, largest);
      } else {
        control.value = it->second;
      }
      return 0;
    };
  }
  std::map<uint32_t, int32_t> values = {{V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_APERTURE_PRIORITY},
                                        {V4L2_CID_EXPOSURE_ABSOLUTE, 157},
                                        {V4L2_CID_GAIN, 64}};
  std::vector<uint32_t> written;
  int32_t largest = 100'000;
};

CameraControls Fixed() {
  CameraControls controls;
  controls.exposure_s = 0.008;
  controls.gain = 3;
  return controls;
}

TEST(V4l2Controls, WritesTheAutomatismOffFirstAndThenTheValue) {
  FakeCamera camera;
  const Status status = ApplyControls(ControlSettings(Fixed()), camera.ioctl());
  EXPECT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(camera.values[V4L2_CID_EXPOSURE_AUTO], V4L2_EXPOSURE_MANUAL);
  EXPECT_EQ(camera.values[V4L2_CID_EXPOSURE_ABSOLUTE], 80);
  EXPECT_EQ(camera.values[V4L2_CID_GAIN], 3);
  EXPECT_EQ(camera.written, (std::vector<uint32_t>{V4L2_CID_EXPOSURE_AUTO,
                                                   V4L2_CID_EXPOSURE_ABSOLUTE, V4L2_CID_GAIN}));
}

TEST(V4l2Controls, AValueThatDoesNotReadBackIsAnError) {
  FakeCamera camera;
  camera.largest = 50;
  const Status status = ApplyControls(ControlSettings(Fixed()), camera.ioctl());
  EXPECT_EQ(status.message(), "the camera has exposure (100 us) = 50, not the 80 written");
}

TEST(V4l2Controls, AMissingControlThatIsNeededIsAnError) {
  FakeCamera camera;
  camera.values.erase(V4L2_CID_EXPOSURE_ABSOLUTE);
  EXPECT_FALSE(ApplyControls(ControlSettings(Fixed()), camera.ioctl()).ok());
}

TEST(V4l2Controls, WhatIsRefusedKeepsNothingElseFromBeingWritten) {
  FakeCamera camera;
  camera.values.erase(V4L2_CID_EXPOSURE_ABSOLUTE);
  CameraControls controls = Fixed();
  controls.white_balance_k = 4000;
  const Status status = ApplyControls(ControlSettings(controls), camera.ioctl());
  EXPECT_EQ(camera.values[V4L2_CID_GAIN], 3);
  for (const char* refused :
       {"exposure (100 us) = 80", "auto white balance = 0: Invalid argument; ",
        "white balance (K) = 4000: Invalid argument"}) {
    EXPECT_NE(status.message().find(refused), std::string::npos) << status.message();
  }
}

TEST(V4l2Controls, TheExposureIsReadAsTheCameraHasIt) {
  FakeCamera camera;
  camera.largest = 50;
  (void)ApplyControls(ControlSettings(Fixed()), camera.ioctl());
  EXPECT_DOUBLE_EQ(ReadExposure(camera.ioctl()).value(), 0.005);
  camera.values.erase(V4L2_CID_EXPOSURE_ABSOLUTE);
  EXPECT_FALSE(ReadExposure(camera.ioctl()).has_value());
  EXPECT_FALSE(ReadExposure("/dev/there-is-no-camera").has_value());
}

TEST(V4l2Controls, UnsetControlsAreLeftAlone) { EXPECT_TRUE(ControlSettings({}).empty()); }

TEST(V4l2Controls, WhiteBalanceAndPowerLineAreFixedToo) {
  CameraControls controls;
  controls.white_balance_k = 4000;
  controls.power_line_hz = 50;
  FakeCamera camera;
  camera.values = {{V4L2_CID_AUTO_WHITE_BALANCE, 1},
                   {V4L2_CID_WHITE_BALANCE_TEMPERATURE, 0},
                   {V4L2_CID_POWER_LINE_FREQUENCY, V4L2_CID_POWER_LINE_FREQUENCY_60HZ}};
  const Status status = ApplyControls(ControlSettings(controls), camera.ioctl());
  EXPECT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(camera.values[V4L2_CID_AUTO_WHITE_BALANCE], 0);
  EXPECT_EQ(camera.values[V4L2_CID_WHITE_BALANCE_TEMPERATURE], 4000);
  EXPECT_EQ(camera.values[V4L2_CID_POWER_LINE_FREQUENCY], V4L2_CID_POWER_LINE_FREQUENCY_50HZ);
}

TEST(V4l2Controls, AMissingDeviceIsNamed) {
  const Status status = ApplyControls(Fixed(), "/dev/there-is-no-camera");
  EXPECT_EQ(status.message(), "/dev/there-is-no-camera: No such file or directory");
}

}  // namespace
}  // namespace geon::device
