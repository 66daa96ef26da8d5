#pragma once

#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "device/back_off.h"
#include "device/frame_source.h"

namespace geon::device {

// `v4l2: images: video: gst:` through OpenCV. Its grabs block, so each opened source is drained by
// a thread of its own, which keeps the newest frame and rings an eventfd: the one place in the
// daemons that has a thread. A grab that never returns (a camera pulled out, on older kernels) is
// left behind with its thread and the source is opened anew.
class CaptureFrameSource : public FrameSource {
 public:
  enum class Kind { kV4l2, kImages, kVideo, kGStreamer };
  CaptureFrameSource(Kind kind, const std::string& target, const FrameSourceOptions& options);
  ~CaptureFrameSource() override;

  int file_descriptor() const override { return event_fd_; }
  Result<std::optional<sensor::Image>> Poll(double time_s) override;
  int reconnects() const override { return reconnects_; }
  Status SetExposure(double exposure_s) override;
  std::string refused() const override { return refused_; }

 private:
  struct Shared;  // between Poll and one drain thread
  void Start(double time_s);
  void Abandon();

  Kind kind_;
  std::string target_;
  FrameSourceOptions options_;
  int event_fd_;
  std::shared_ptr<Shared> shared_;
  std::thread thread_;
  BackOff back_off_;
  double last_frame_s_ = 0.0;
  std::string trouble_;
  std::string refused_;
  bool delivered_ = false;  // since it was last opened
  bool ever_delivered_ = false;
  int reconnects_ = 0;
  int32_t seq_ = 0;
};

}  // namespace geon::device
