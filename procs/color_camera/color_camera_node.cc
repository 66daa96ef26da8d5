#include "procs/color_camera/color_camera_node.h"

#include <spdlog/spdlog.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <utility>
#include <vector>

#include "base/time.h"
#include "messaging/channels.h"
#include "messaging/clock.h"
#include "sensor/laser_state.h"

namespace geon::color_camera {
namespace {

constexpr double kPollPeriod_s = 0.1;  // time-outs and reopening; frames come by the descriptor

sensor::Image CompressJpeg(sensor::Image image, int quality) {
  const cv::Mat pixels(image.height_px, image.width_px, CV_8UC3, image.data.data(),
                       static_cast<size_t>(image.row_stride_bytes));
  std::vector<uint8_t> file;
  cv::imencode(".jpg", pixels, file, {cv::IMWRITE_JPEG_QUALITY, quality});
  image.data = std::move(file);
  image.row_stride_bytes = 0;
  image.format = sensor::PixelFormat::kJpeg;
  return image;
}

}  // namespace

ColorCameraNode::ColorCameraNode(const ColorCameraConfig& config, std::string_view channel,
                                 std::unique_ptr<device::FrameSource> source, messaging::Bus* bus,
                                 messaging::PollLoop* loop, messaging::HealthReporter* health)
    : config_(config), channel_(channel), source_(std::move(source)), bus_(bus), health_(health) {
  if (config.exposure) {
    exposure_.emplace(*config.exposure);
    FollowLasers(loop);
  }
  loop->Watch(source_->file_descriptor(), [this] { PollSource(); });
  loop->Every(kPollPeriod_s, [this] { PollSource(); });
}

void ColorCameraNode::PollSource() {
  const double now_s = messaging::MonotonicSeconds();
  Result<std::optional<sensor::Image>> frame = source_->Poll(now_s);
  health_->set_reconnects(source_->reconnects());
  if (!frame.ok()) {
    health_->SetLevel(sensor::HealthLevel::kFault, frame.message());
    if (troubles_.Pass(now_s)) spdlog::warn("no frames: {}", frame.message());
    return;
  }
  if (!frame->has_value()) return;
  ReportHealth();
  // By the frames' own stamps, with slack for their jitter. A clock set back does not stop the
  // stream.
  const int64_t utime = (*frame)->utime;
  const int64_t period_us = MicrosecondsFromSeconds(1.0 / config_.max_rate_hz);
  const int64_t since_us = utime - last_utime_;
  if (since_us >= 0 && since_us < period_us - period_us / 10) return;
  last_utime_ = utime;
  ControlExposure(**frame);
  Publish(std::move(**frame));
}

// A stripe outshines the target it lies on.
void ColorCameraNode::FollowLasers(messaging::PollLoop* loop) {
  bus_->Subscribe<sensor::LaserState>(
      messaging::kLaserState, [this](const sensor::LaserState& lasers) {
        const bool burned = std::exchange(laser_burns_, lasers.laser != sensor::Laser::kNone);
        if (burned || laser_burns_) dark_from_utime_ = messaging::Utime();
      });
  loop->Watch(bus_->file_descriptor(), [bus = bus_] { bus->HandlePending(); });
}

void ColorCameraNode::ControlExposure(const sensor::Image& image) {
  if (!exposure_ || laser_burns_ || image.utime < dark_from_utime_) return;
  const std::optional<double> exposure_s = exposure_->Judge(image);
  if (!exposure_s) return;
  const Status status = source_->SetExposure(*exposure_s);
  if (status.ok()) {
    spdlog::info("another exposure is asked for exposure_ms={:.2f}", 1e3 * *exposure_s);
    return;
  }
  exposure_trouble_ = status.In("the exposure stays as it is").message();
  exposure_.reset();
}

void ColorCameraNode::ReportHealth() {
  std::string warning = source_->refused();
  if (!exposure_trouble_.empty()) warning += (warning.empty() ? "" : "; ") + exposure_trouble_;
  health_->SetLevel(warning.empty() ? sensor::HealthLevel::kOk : sensor::HealthLevel::kWarn,
                    warning);
  if (warning != warned_ && !warning.empty()) spdlog::warn("camera: {}", warning);
  warned_ = warning;
}

void ColorCameraNode::Publish(sensor::Image image) {
  image.seq = ++seq_;
  health_->ReportAge(SecondsFromMicroseconds(messaging::Utime() - image.utime));
  if (config_.encoding == sensor::PixelFormat::kJpeg) {
    image = CompressJpeg(std::move(image), config_.jpeg_quality);
  }
  bus_->Publish(channel_, image);
}

}  // namespace geon::color_camera
