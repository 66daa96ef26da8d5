#include "device/frame_message.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace geon::device {
namespace {

constexpr int64_t kLargestSide = 8192;

// The integer `key` within [least, most], or an error that names it.
Result<int64_t> Integer(const nlohmann::json& header, const char* key, int64_t least,
                        int64_t most) {
  const auto it = header.find(key);
  if (it == header.end() || !it->is_number_integer()) {
    return Status::Error(std::string("frame header: no integer \"") + key + "\"");
  }
  if (it->is_number_unsigned() &&
      it->get<uint64_t>() > static_cast<uint64_t>(std::numeric_limits<int64_t>::max())) {
    return Status::Error(std::string("frame header: \"") + key + "\" is out of range");
  }
  const auto value = it->get<int64_t>();
  if (value < least || value > most) {
    return Status::Error(std::string("frame header: \"") + key + "\" = " + std::to_string(value) +
                         " is not within " + std::to_string(least) + ".." + std::to_string(most));
  }
  return value;
}

}  // namespace

Result<sensor::Image> ParseFrame(std::string_view text, std::span<const uint8_t> pixels) {
  const nlohmann::json header = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!header.is_object()) return Status::Error("frame header: not a JSON object");
  constexpr int64_t kMaxInt32 = std::numeric_limits<int32_t>::max();
  const Result<int64_t> seq = Integer(header, "seq", 0, kMaxInt32);
  if (!seq.ok()) return seq.status();
  const Result<int64_t> utime =
      Integer(header, "utime", 0, std::numeric_limits<int64_t>::max() / 2);
  if (!utime.ok()) return utime.status();
  const Result<int64_t> width = Integer(header, "width", 1, kLargestSide);
  if (!width.ok()) return width.status();
  const Result<int64_t> height = Integer(header, "height", 1, kLargestSide);
  if (!height.ok()) return height.status();
  const Result<int64_t> exposure_us = Integer(header, "exposure_us", 0, 10'000'000);
  if (!exposure_us.ok()) return exposure_us.status();

  sensor::Image image;
  const auto format = header.find("format");
  if (format != header.end() && *format == "bgr8") {
    image.format = sensor::PixelFormat::kBgr8;
  } else if (format != header.end() && *format == "gray8") {
    image.format = sensor::PixelFormat::kGray8;
  } else {
    return Status::Error("frame header: \"format\" is neither \"bgr8\" nor \"gray8\"");
  }
  image.seq = static_cast<int32_t>(*seq);
  image.utime = *utime;
  image.width_px = static_cast<int>(*width);
  image.height_px = static_cast<int>(*height);
  if (*exposure_us > 0) image.exposure_s = 1e-6 * static_cast<double>(*exposure_us);
  image.row_stride_bytes = image.width_px * ChannelCount(image.format);
  const int64_t expected = *height * image.row_stride_bytes;
  if (static_cast<int64_t>(pixels.size()) != expected) {
    return Status::Error("frame of " + std::to_string(pixels.size()) +
                         " bytes where its header says " + std::to_string(expected));
  }
  image.data.assign(pixels.begin(), pixels.end());
  return image;
}

}  // namespace geon::device
