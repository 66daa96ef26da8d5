#include "device/capture_frame_source.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <utility>

#include "base/contracts.h"
#include "base/time.h"
#include "device/frame_watch.h"

namespace geon::device {
namespace {

using Kind = CaptureFrameSource::Kind;
using SteadyClock = std::chrono::steady_clock;
using SystemClock = std::chrono::system_clock;

template <typename Clock>
int64_t Microseconds() {
  return std::chrono::duration_cast<std::chrono::microseconds>(Clock::now().time_since_epoch())
      .count();
}

int Backend(Kind kind) {
  switch (kind) {
    case Kind::kV4l2:
      return cv::CAP_V4L2;
    case Kind::kImages:
      return cv::CAP_IMAGES;
    case Kind::kVideo:
      return cv::CAP_FFMPEG;
    case Kind::kGStreamer:
      return cv::CAP_GSTREAMER;
  }
  return cv::CAP_ANY;
}

bool IsFile(Kind kind) { return kind == Kind::kImages || kind == Kind::kVideo; }

// What the frame becomes: our pixel format, rows tightly packed.
Result<sensor::Image> ToImage(const cv::Mat& frame, const FrameSourceOptions& options) {
  if (frame.cols != options.width_px || frame.rows != options.height_px) {
    return Status::Error("a frame of " + std::to_string(frame.cols) + "x" +
                         std::to_string(frame.rows) + ", not " + std::to_string(options.width_px) +
                         "x" + std::to_string(options.height_px));
  }
  const bool grey = options.format == sensor::PixelFormat::kGray8;
  cv::Mat pixels = frame;
  if (frame.type() == CV_8UC3 && grey) {
    cv::cvtColor(frame, pixels, cv::COLOR_BGR2GRAY);
  } else if (frame.type() == CV_8UC1 && !grey) {
    cv::cvtColor(frame, pixels, cv::COLOR_GRAY2BGR);
  } else if (frame.type() != CV_8UC1 && frame.type() != CV_8UC3) {
    return Status::Error("a frame that is neither grey nor colour of 8 bits");
  }
  if (!pixels.isContinuous()) pixels = pixels.clone();
  sensor::Image image;
  image.width_px = pixels.cols;
  image.height_px = pixels.rows;
  image.format = options.format;
  image.row_stride_bytes = pixels.cols * pixels.channels();
  image.data.assign(pixels.data, pixels.data + pixels.total() * pixels.elemSize());
  return image;
}

}  // namespace

struct CaptureFrameSource::Shared {
  Kind kind;
  std::string target;
  FrameSourceOptions options;
  int event_fd;  // a duplicate: the thread may outlive the source

  std::mutex mutex;
  std::condition_variable ended_changed;
  bool stop = false;
  bool ended = false;
  std::optional<sensor::Image> newest;
  int64_t grabbed = 0;  // frames since opened, dropped ones included
  std::string trouble;
  std::string refused;  // controls that the camera does not take
  std::optional<double> asked_exposure_s;

  // The thread's own: as the camera had it when last asked, and before.
  std::optional<double> exposure_s, exposure_before_s;

  ~Shared() { close(event_fd); }
  void Run();
  Status Open(cv::VideoCapture* capture);
  void Control(const CameraControls& controls);
  void ControlAsAsked();
  int64_t ExposureStart(cv::VideoCapture* capture, bool* stamped) const;
  Status Drain(cv::VideoCapture* capture);
  bool Stopped() {
    const std::lock_guard lock(mutex);
    return stop;
  }
  void Ring() const {
    const uint64_t one = 1;
    (void)!write(event_fd, &one, sizeof(one));  // full means that it rings already
  }
};

Status CaptureFrameSource::Shared::Open(cv::VideoCapture* capture) {
  if (!capture->open(target, Backend(kind))) return Status::Error("it does not open");
  if (kind != Kind::kV4l2) return Status::Ok();
  capture->set(cv::CAP_PROP_BUFFERSIZE, 1);
  capture->set(cv::CAP_PROP_FRAME_WIDTH, options.width_px);
  capture->set(cv::CAP_PROP_FRAME_HEIGHT, options.height_px);
  // Some cameras forget their controls when the stream starts: the first frame, then the controls.
  if (!capture->grab()) return Status::Error("it delivers no first frame");
  Control(options.controls);
  return Status::Ok();
}

// A camera that refuses a control still delivers frames: it is told, and they are used.
void CaptureFrameSource::Shared::Control(const CameraControls& controls) {
  const Status status = ApplyControls(controls, target);
  exposure_before_s = exposure_s;
  exposure_s = ReadExposure(target);
  const std::lock_guard lock(mutex);
  refused = status.message();
}

void CaptureFrameSource::Shared::ControlAsAsked() {
  CameraControls controls = options.controls;
  {
    const std::lock_guard lock(mutex);
    if (!asked_exposure_s) return;
    controls.exposure_s = std::exchange(asked_exposure_s, std::nullopt);
  }
  Control(controls);
}

// Start of the exposure of the frame just grabbed: what the stamp says, less the exposure (the
// longer one, as long as frames may come that were taken before it was changed) and the delay a
// stamp may have.
int64_t CaptureFrameSource::Shared::ExposureStart(cv::VideoCapture* capture, bool* stamped) const {
  const int64_t now_utime = Microseconds<SystemClock>();
  if (IsFile(kind)) {
    *stamped = false;
    return now_utime;
  }
  int64_t utime = now_utime;
  double delay_s = options.unstamped_delay_s;
  *stamped = false;
  if (kind == Kind::kV4l2) {
    const double monotonic_ms = capture->get(cv::CAP_PROP_POS_MSEC);
    const int64_t age_us =
        Microseconds<SteadyClock>() - static_cast<int64_t>(std::llround(monotonic_ms * 1e3));
    if (monotonic_ms > 0.0 && age_us >= 0 && age_us < 5'000'000) {
      *stamped = true;
      utime = now_utime - age_us;
      delay_s = options.stamp_delay_s;
    }
  }
  const double longest_s = std::max(exposure_s.value_or(options.controls.exposure_s.value_or(0.0)),
                                    exposure_before_s.value_or(0.0));
  return utime - MicrosecondsFromSeconds(longest_s + delay_s);
}

Status CaptureFrameSource::Shared::Drain(cv::VideoCapture* capture) {
  FrameWatch watch;
  auto next_file_frame = SteadyClock::now();
  while (!Stopped()) {
    if (IsFile(kind)) {
      std::this_thread::sleep_until(next_file_frame);
      next_file_frame += std::chrono::duration_cast<SteadyClock::duration>(
          std::chrono::duration<double>(1.0 / options.file_rate_hz));
    }
    ControlAsAsked();
    if (!capture->grab()) {
      return IsFile(kind) ? Status::Ok() : Status::Error("it delivers no more frames");
    }
    bool stamped = false;
    const int64_t utime = ExposureStart(capture, &stamped);
    cv::Mat frame;
    if (!capture->retrieve(frame) || frame.empty()) return Status::Error("a frame without pixels");
    Result<sensor::Image> image = ToImage(frame, options);
    if (!image.ok()) return image.status();
    const bool fresh =
        IsFile(kind) || (stamped ? watch.IsFreshStamp(utime) : watch.IsFreshContent(image->data));
    const std::lock_guard lock(mutex);
    if (!fresh) {
      trouble = "it repeats the same frame";
      continue;
    }
    image->utime = utime;
    image->exposure_s = exposure_s;
    newest = std::move(*image);
    ++grabbed;
    trouble.clear();
    Ring();
  }
  return Status::Ok();
}

void CaptureFrameSource::Shared::Run() {
  Status status;
  try {
    do {  // a file that ends starts again
      cv::VideoCapture capture;
      status = Open(&capture);
      if (status.ok()) status = Drain(&capture);
    } while (status.ok() && IsFile(kind) && !Stopped() && grabbed > 0);
    if (status.ok() && IsFile(kind) && grabbed == 0) status = Status::Error("it holds no frames");
  } catch (const std::exception& error) {
    status = Status::Error(error.what());
  }
  const std::lock_guard lock(mutex);
  if (!status.ok()) trouble = status.message();
  ended = true;
  Ring();
  ended_changed.notify_all();
}

CaptureFrameSource::CaptureFrameSource(Kind kind, const std::string& target,
                                       const FrameSourceOptions& options)
    : kind_(kind),
      target_(target),
      options_(options),
      event_fd_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
      back_off_(options.first_retry_s, options.longest_retry_s) {
  Require(event_fd_ >= 0, "eventfd failed");
  Require(options.file_rate_hz > 0.0, "file_rate_hz must be positive");
}

CaptureFrameSource::~CaptureFrameSource() {
  Abandon();
  close(event_fd_);
}

void CaptureFrameSource::Start(double time_s) {
  shared_ = std::make_shared<Shared>();
  shared_->kind = kind_;
  shared_->target = target_;
  shared_->options = options_;
  shared_->event_fd = dup(event_fd_);
  thread_ = std::thread([shared = shared_] { shared->Run(); });
  last_frame_s_ = time_s;
  delivered_ = false;
}

// Ends the drain thread, or leaves it behind when its grab does not return.
void CaptureFrameSource::Abandon() {
  if (!shared_) return;
  std::unique_lock lock(shared_->mutex);
  shared_->stop = true;
  const bool ended = shared_->ended_changed.wait_for(lock, std::chrono::milliseconds(200),
                                                     [this] { return shared_->ended; });
  lock.unlock();
  if (ended) {
    thread_.join();
  } else {
    thread_.detach();
  }
  shared_.reset();
}

Result<std::optional<sensor::Image>> CaptureFrameSource::Poll(double time_s) {
  uint64_t rings = 0;
  (void)!read(event_fd_, &rings, sizeof(rings));
  if (!shared_) {
    if (!back_off_.Due(time_s)) return Status::Error(target_ + ": " + trouble_);
    Start(time_s);
    return std::optional<sensor::Image>();
  }
  std::optional<sensor::Image> image;
  bool ended = false;
  {
    const std::lock_guard lock(shared_->mutex);
    image = std::exchange(shared_->newest, std::nullopt);
    ended = shared_->ended;
    trouble_ = shared_->trouble;
    refused_ = shared_->refused;
    if (image) image->seq = seq_ + static_cast<int32_t>(shared_->grabbed);
    if (ended) seq_ += static_cast<int32_t>(shared_->grabbed);
  }
  if (image) {
    last_frame_s_ = time_s;
    back_off_.Succeeded();
    if (!delivered_) reconnects_ += ever_delivered_ ? 1 : 0;
    delivered_ = ever_delivered_ = true;
  }
  const bool silent = time_s - last_frame_s_ >= options_.timeout_s;
  if (ended || silent) {
    if (trouble_.empty())
      trouble_ = "no frame for " + std::to_string(std::lround(1e3 * options_.timeout_s)) + " ms";
    Abandon();
    back_off_.Failed(time_s);
    if (!image) return Status::Error(target_ + ": " + trouble_);
  }
  return image;
}

Status CaptureFrameSource::SetExposure(double exposure_s) {
  Require(exposure_s > 0.0, "SetExposure: exposure_s must be positive");
  if (kind_ != Kind::kV4l2) {
    return Status::Error(target_ + ": frames of this kind of source keep their exposure");
  }
  options_.controls.exposure_s = exposure_s;  // also of the camera when it is opened again
  if (shared_) {
    const std::lock_guard lock(shared_->mutex);
    shared_->asked_exposure_s = exposure_s;
  }
  return Status::Ok();
}

}  // namespace geon::device
