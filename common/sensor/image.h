#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace geon::sensor {

enum class PixelFormat { kGray8, kRgb8, kBgr8, kJpeg, kPng };

// One frame as a camera delivered it. `utime` is the start of the exposure on the acquiring host's
// clock, `seq` counts the camera's frames so that a gap shows a lost one. `data` holds
// height x row_stride_bytes bytes, or the whole file for the compressed formats (stride 0).
struct Image {
  int64_t utime = 0;
  int32_t seq = 0;
  int width_px = 0;
  int height_px = 0;
  int row_stride_bytes = 0;
  PixelFormat format = PixelFormat::kGray8;
  std::vector<uint8_t> data;
  std::optional<double> exposure_s;  // with which it was taken, where the camera says so
};

constexpr int ChannelCount(PixelFormat format) {
  switch (format) {
    case PixelFormat::kGray8:
      return 1;
    case PixelFormat::kRgb8:
    case PixelFormat::kBgr8:
      return 3;
    case PixelFormat::kJpeg:
    case PixelFormat::kPng:
      return 0;
  }
  return 0;
}

// Axis-aligned box in pixels: columns [u, u + w), rows [v, v + h).
struct PixelBox {
  int u_px = 0;
  int v_px = 0;
  int w_px = 0;
  int h_px = 0;
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

}  // namespace geon::sensor
