// Conversions of what devices say and are told: images, stripes, head, base, lasers.
#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>

#include "base/time.h"
#include "messaging/wire.h"
#include "messaging/wire_checks.h"

namespace geon::messaging {
namespace {

using geon::image_t;
using sensor::PixelFormat;

struct FormatCode {
  PixelFormat format;
  int32_t code;
};
const std::array<FormatCode, 5> kFormatCodes = {{
    {PixelFormat::kGray8, image_t::PIXEL_FORMAT_GRAY},
    {PixelFormat::kRgb8, image_t::PIXEL_FORMAT_RGB},
    {PixelFormat::kBgr8, image_t::PIXEL_FORMAT_BGR},
    {PixelFormat::kJpeg, image_t::PIXEL_FORMAT_MJPEG},
    {PixelFormat::kPng, image_t::PIXEL_FORMAT_PNG},
}};

// Larger images than any camera of this robot would be nonsense on the wire.
constexpr int32_t kLargestSide = 16384;

// Why an image cannot be one; empty when it can. An empty image (no size, no data) is legal:
// "none".
std::string WhyNotAnImage(const sensor::Image& image) {
  const bool none = image.width_px == 0 && image.height_px == 0 && image.data.empty();
  if (none) return "";
  if (image.width_px <= 0 || image.height_px <= 0 || image.width_px > kLargestSide ||
      image.height_px > kLargestSide) {
    return "has the size " + std::to_string(image.width_px) + "x" + std::to_string(image.height_px);
  }
  const int channels = ChannelCount(image.format);
  if (channels == 0) {
    return image.data.empty() ? "has no data" : image.row_stride_bytes != 0 ? "has a stride" : "";
  }
  if (image.row_stride_bytes < image.width_px * channels) {
    return "has a stride of " + std::to_string(image.row_stride_bytes) + " bytes for " +
           std::to_string(image.width_px) + " pixels";
  }
  const auto expected =
      static_cast<size_t>(image.row_stride_bytes) * static_cast<size_t>(image.height_px);
  if (image.data.size() == expected) return "";
  return "has " + std::to_string(image.data.size()) +
         " bytes, not height x stride = " + std::to_string(expected);
}

// The exposure is a note on the image: the type, released, has no field for it.
constexpr const char* kExposureKey = "exposure_us";
constexpr int64_t kLongestExposure_us = 10'000'000;

image_metadata_t ExposureNote(double exposure_s) {
  const std::string text = std::to_string(MicrosecondsFromSeconds(exposure_s));
  image_metadata_t note{};
  note.key = kExposureKey;
  note.value.assign(text.begin(), text.end());
  note.n = WireCount(note.value);
  return note;
}

// Nothing when the note is no length of time.
std::optional<double> ReadExposureNote(const image_metadata_t& note) {
  const char* const begin = reinterpret_cast<const char*>(note.value.data());
  const char* const end = begin + note.value.size();
  int64_t exposure_us = 0;
  const auto [rest, error] = std::from_chars(begin, end, exposure_us);
  if (error != std::errc() || rest != end) return std::nullopt;
  if (exposure_us <= 0 || exposure_us > kLongestExposure_us) return std::nullopt;
  return SecondsFromMicroseconds(exposure_us);
}

constexpr sensor::DeviceStatus kLastStatus = sensor::DeviceStatus::kFault;
constexpr sensor::Laser kLastLaserLit = sensor::Laser::kVertical;

}  // namespace

image_t ToWire(const sensor::Image& image) {
  const std::string why_not = WhyNotAnImage(image);
  Require(why_not.empty(), "image " + why_not);
  image_t wire{};
  wire.utime = image.utime;
  wire.seq = image.seq;
  wire.width = image.width_px;
  wire.height = image.height_px;
  wire.row_stride = image.row_stride_bytes;
  for (const FormatCode& code : kFormatCodes) {
    if (code.format == image.format) wire.pixelformat = code.code;
  }
  wire.size = WireCount(image.data);
  wire.data = image.data;
  if (image.exposure_s) wire.metadata.push_back(ExposureNote(*image.exposure_s));
  wire.nmetadata = WireCount(wire.metadata);
  return wire;
}

Result<sensor::Image> FromWire(const image_t& wire) {
  sensor::Image image;
  image.utime = wire.utime;
  image.seq = wire.seq;
  image.width_px = wire.width;
  image.height_px = wire.height;
  image.row_stride_bytes = wire.row_stride;
  const auto code = std::find_if(kFormatCodes.begin(), kFormatCodes.end(),
                                 [&](const FormatCode& c) { return c.code == wire.pixelformat; });
  if (code == kFormatCodes.end()) {
    return Status::Error("image has the unknown pixelformat " + std::to_string(wire.pixelformat));
  }
  image.format = code->format;
  image.data = wire.data;
  const std::string why_not = WhyNotAnImage(image);
  if (!why_not.empty()) return Status::Error("image " + why_not);
  for (const image_metadata_t& note : wire.metadata) {
    if (note.key != kExposureKey) continue;
    image.exposure_s = ReadExposureNote(note);
    if (!image.exposure_s) return Status::Error("image has an exposure_us that is none");
  }
  return image;
}

geon::stripe_t ToWire(const sensor::Stripe& stripe) {
  geon::stripe_t wire{};
  wire.utime = stripe.utime;
  wire.seq = stripe.seq;
  wire.scan_id = stripe.scan_id;
  wire.stripe_index = stripe.stripe_index;
  wire.attempt = stripe.attempt;
  wire.laser = static_cast<int32_t>(stripe.laser);
  wire.status = static_cast<int32_t>(stripe.status);
  wire.pan_rad = stripe.pan_rad;
  wire.tilt_rad = stripe.tilt_rad;
  wire.x_m = stripe.x_m;
  wire.y_m = stripe.y_m;
  wire.heading_rad = stripe.heading_rad;
  wire.lit_utime = stripe.lit_utime;
  wire.unlit_utime = stripe.unlit_utime;
  wire.lit_peak_level = stripe.lit_peak;
  wire.noise_level = stripe.noise_level;
  wire.difference = ToWire(stripe.difference);
  return wire;
}

Result<sensor::Stripe> FromWire(const geon::stripe_t& wire) {
  FieldChecks checks;
  sensor::Stripe stripe;
  stripe.utime = wire.utime;
  stripe.seq = wire.seq;
  stripe.scan_id = wire.scan_id;
  stripe.stripe_index = wire.stripe_index;
  stripe.attempt = wire.attempt;
  stripe.laser = checks.Enumeration("laser", wire.laser, kLastLaserLit);
  stripe.status = checks.Enumeration("status", wire.status, sensor::StripeStatus::kMoving);
  stripe.pan_rad = wire.pan_rad;
  stripe.tilt_rad = wire.tilt_rad;
  stripe.x_m = wire.x_m;
  stripe.y_m = wire.y_m;
  stripe.heading_rad = wire.heading_rad;
  stripe.lit_utime = wire.lit_utime;
  stripe.unlit_utime = wire.unlit_utime;
  stripe.lit_peak = wire.lit_peak_level;
  stripe.noise_level = wire.noise_level;
  stripe.difference = checks.Part("difference", FromWire(wire.difference));
  const PixelFormat format = stripe.difference.format;
  checks.Require(format == PixelFormat::kGray8 || format == PixelFormat::kPng, "difference",
                 "is neither grey nor PNG");
  checks.Finite("pan_rad", wire.pan_rad);
  checks.Finite("tilt_rad", wire.tilt_rad);
  return checks.Finish(std::move(stripe));
}

geon::scan_command_t ToWire(const sensor::ScanCommand& command) {
  geon::scan_command_t wire{};
  wire.utime = command.utime;
  wire.seq = command.seq;
  wire.scan_id = command.scan_id;
  wire.stripe_index = command.stripe_index;
  wire.attempt = command.attempt;
  wire.laser = static_cast<int32_t>(command.laser);
  return wire;
}

Result<sensor::ScanCommand> FromWire(const geon::scan_command_t& wire) {
  FieldChecks checks;
  return checks.Finish(sensor::ScanCommand{wire.utime, wire.seq, wire.scan_id, wire.stripe_index,
                                           wire.attempt,
                                           checks.Enumeration("laser", wire.laser, kLastLaserLit)});
}

geon::ptu_state_t ToWire(const sensor::PtuState& state) {
  geon::ptu_state_t wire{};
  wire.utime = state.utime;
  wire.seq = state.seq;
  wire.status = static_cast<int32_t>(state.status);
  wire.pan_rad = state.pan_rad;
  wire.tilt_rad = state.tilt_rad;
  wire.pan_target_rad = state.pan_target_rad;
  wire.tilt_target_rad = state.tilt_target_rad;
  wire.pan_min_rad = state.pan_min_rad;
  wire.pan_max_rad = state.pan_max_rad;
  wire.tilt_min_rad = state.tilt_min_rad;
  wire.tilt_max_rad = state.tilt_max_rad;
  wire.moving = state.moving ? 1 : 0;
  wire.command_id = state.command_id;
  return wire;
}

Result<sensor::PtuState> FromWire(const geon::ptu_state_t& wire) {
  FieldChecks checks;
  sensor::PtuState state;
  state.utime = wire.utime;
  state.seq = wire.seq;
  state.status = checks.Enumeration("status", wire.status, kLastStatus);
  state.pan_rad = wire.pan_rad;
  state.tilt_rad = wire.tilt_rad;
  state.pan_target_rad = wire.pan_target_rad;
  state.tilt_target_rad = wire.tilt_target_rad;
  state.pan_min_rad = wire.pan_min_rad;
  state.pan_max_rad = wire.pan_max_rad;
  state.tilt_min_rad = wire.tilt_min_rad;
  state.tilt_max_rad = wire.tilt_max_rad;
  state.moving = wire.moving != 0;
  state.command_id = wire.command_id;
  if (state.status == sensor::DeviceStatus::kReady) {
    checks.Finite("pan_rad", wire.pan_rad);
    checks.Finite("tilt_rad", wire.tilt_rad);
  }
  return checks.Finish(state);
}

geon::ptu_command_t ToWire(const sensor::PtuCommand& command) {
  geon::ptu_command_t wire{};
  wire.utime = command.utime;
  wire.seq = command.seq;
  wire.command_id = command.command_id;
  wire.pan_rad = command.pan_rad;
  wire.tilt_rad = command.tilt_rad;
  wire.speed_rad_s = command.speed_rad_s;
  return wire;
}

Result<sensor::PtuCommand> FromWire(const geon::ptu_command_t& wire) {
  FieldChecks checks;
  checks.Finite("pan_rad", wire.pan_rad);
  checks.Finite("tilt_rad", wire.tilt_rad);
  checks.Finite("speed_rad_s", wire.speed_rad_s);
  checks.Require(!(wire.speed_rad_s < 0.0), "speed_rad_s", "is negative");
  return checks.Finish(sensor::PtuCommand{wire.utime, wire.seq, wire.command_id, wire.pan_rad,
                                          wire.tilt_rad, wire.speed_rad_s});
}

geon::laser_state_t ToWire(const sensor::LaserState& state) {
  geon::laser_state_t wire{};
  wire.utime = state.utime;
  wire.seq = state.seq;
  wire.status = static_cast<int32_t>(state.status);
  wire.laser = static_cast<int32_t>(state.laser);
  wire.on_time_s = state.on_time_s;
  return wire;
}

Result<sensor::LaserState> FromWire(const geon::laser_state_t& wire) {
  FieldChecks checks;
  sensor::LaserState state;
  state.utime = wire.utime;
  state.seq = wire.seq;
  state.status = checks.Enumeration("status", wire.status, kLastStatus);
  state.laser = checks.Enumeration("laser", wire.laser, kLastLaserLit);
  state.on_time_s = wire.on_time_s;
  return checks.Finish(state);
}

}  // namespace geon::messaging
