#include "procs/stripe_camera/stripe_camera_node.h"

#include <spdlog/spdlog.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <utility>
#include <vector>

#include "base/time.h"
#include "messaging/channels.h"
#include "messaging/clock.h"
#include "sensor/laser_state.h"

namespace geon::stripe_camera {
namespace {

constexpr double kServicePeriod_s = 0.005;
constexpr double kSourcePeriod_s = 0.1;
constexpr double kLaserStatePeriod_s = 0.1;

const char* ToText(sensor::StripeStatus status) {
  switch (status) {
    case sensor::StripeStatus::kLit:
      return "lit";
    case sensor::StripeStatus::kNotLit:
      return "not lit";
    case sensor::StripeStatus::kLaserFault:
      return "laser fault";
    case sensor::StripeStatus::kCameraFault:
      return "camera fault";
    case sensor::StripeStatus::kMoving:
      return "moving";
  }
  return "unknown";
}

void CompressPng(sensor::Image* image) {
  if (image->data.empty()) return;
  const cv::Mat pixels(image->height_px, image->width_px, CV_8UC1, image->data.data());
  std::vector<uint8_t> file;
  cv::imencode(".png", pixels, file, {cv::IMWRITE_PNG_COMPRESSION, 1});
  image->data = std::move(file);
  image->row_stride_bytes = 0;
  image->format = sensor::PixelFormat::kPng;
}

}  // namespace

StripeCameraNode::StripeCameraNode(const StripeCameraConfig& config,
                                   std::unique_ptr<device::FrameSource> source, messaging::Bus* bus,
                                   messaging::PollLoop* loop, messaging::HealthReporter* health)
    : source_(std::move(source)),
      link_(config.lasers),
      lasers_(config.laser_driver),
      capture_(config.capture),
      bus_(bus),
      health_(health) {
  using messaging::MonotonicSeconds;
  bus_->Subscribe<sensor::ScanCommand>(messaging::kScanCommand,
                                       [this](const sensor::ScanCommand& command) {
                                         capture_.OnCommand(command, MonotonicSeconds());
                                         PublishAnswers();
                                       });
  bus_->SubscribeLatest<sensor::PtuState>(
      messaging::kPtuState,
      [this](const sensor::PtuState& state) { capture_.OnPtuState(state, MonotonicSeconds()); });
  bus_->SubscribeLatest<sensor::BaseState>(
      messaging::kBaseState,
      [this](const sensor::BaseState& state) { capture_.OnBaseState(state, MonotonicSeconds()); });
  loop->OnStop([this] {
    const Status status = device::SwitchOffNow(&link_);
    if (!status.ok()) spdlog::error("lasers: {}", status.message());
  });
  loop->Watch(bus_->file_descriptor(), [this] {
    bus_->HandlePending();
    ServeLasers();
  });
  loop->Watch(source_->file_descriptor(), [this] { PollSource(); });
  loop->Every(kServicePeriod_s, [this] { ServeLasers(); });
  loop->Every(kSourcePeriod_s, [this] { PollSource(); });
  loop->Every(kLaserStatePeriod_s, [this] {
    PublishLaserState();
    ReportHealth();
  });
}

void StripeCameraNode::ServeLasers() {
  const double now_s = messaging::MonotonicSeconds();
  capture_.Tick(now_s);
  lasers_.Request(capture_.wanted_laser(now_s));
  device::Pump(&link_, &lasers_, now_s);
  capture_.OnLaser(lasers_.report(), now_s);
  PublishAnswers();
  const device::LaserReport& report = lasers_.report();
  if (report.laser != laser_state_.laser || report.status != laser_state_.status) {
    PublishLaserState();
  }
}

void StripeCameraNode::PollSource() {
  const double now_s = messaging::MonotonicSeconds();
  Result<std::optional<sensor::Image>> frame = source_->Poll(now_s);
  if (!frame.ok()) {
    camera_trouble_ = frame.message();
    if (troubles_.Pass(now_s)) spdlog::warn("no frames: {}", frame.message());
    return;
  }
  if (!frame->has_value()) return;
  camera_trouble_.clear();
  // The stamp's age carries it over to the clock of the lasers' confirmations.
  const double age_s = SecondsFromMicroseconds(messaging::Utime() - (*frame)->utime);
  capture_.OnFrame(**frame, now_s - age_s, now_s);
  ServeLasers();
}

void StripeCameraNode::PublishAnswers() {
  for (sensor::Stripe& stripe : capture_.TakeAnswers()) {
    if (stripe.utime == 0) stripe.utime = messaging::Utime();
    stripe.seq = ++stripe_seq_;
    stripe.difference.seq = stripe.seq;
    CompressPng(&stripe.difference);
    bus_->Publish(messaging::kStripe, stripe);
    spdlog::info("stripe scan={} stripe={} attempt={} {} peak={:.0f} noise={:.2f} bytes={}{}",
                 stripe.scan_id, stripe.stripe_index, stripe.attempt, ToText(stripe.status),
                 stripe.lit_peak, stripe.noise_level, stripe.difference.data.size(),
                 stripe.status == sensor::StripeStatus::kLit ? "" : ": " + capture_.reason());
  }
}

void StripeCameraNode::PublishLaserState() {
  const device::LaserReport& report = lasers_.report();
  laser_state_.utime = messaging::Utime();
  laser_state_.seq += 1;
  laser_state_.status = report.status;
  laser_state_.laser = report.laser;
  laser_state_.on_time_s = report.on_time_s;
  bus_->Publish(messaging::kLaserState, laser_state_);
}

void StripeCameraNode::ReportHealth() {
  health_->set_reconnects(link_.reconnects() + source_->reconnects());
  const device::LaserReport& report = lasers_.report();
  if (!link_.is_open()) {
    health_->SetLevel(sensor::HealthLevel::kFault, "lasers: " + link_.trouble());
  } else if (report.status != sensor::DeviceStatus::kReady) {
    health_->SetLevel(report.status == sensor::DeviceStatus::kFault
                          ? sensor::HealthLevel::kFault
                          : sensor::HealthLevel::kStarting,
                      "lasers: " + report.text);
  } else if (!camera_trouble_.empty()) {
    health_->SetLevel(sensor::HealthLevel::kFault, camera_trouble_);
  } else if (const std::string refused = source_->refused(); !refused.empty()) {
    health_->SetLevel(sensor::HealthLevel::kWarn, refused);
  } else {
    health_->SetLevel(sensor::HealthLevel::kOk);
  }
}

}  // namespace geon::stripe_camera
