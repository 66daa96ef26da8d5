#pragma once

#include <cstdint>
#include <optional>

#include "sensor/image.h"

namespace geon::sensor {

// The colour image that a decision was taken on, small enough to record, with what was seen in it.
// One per decision, not a stream.
struct TargetView {
  int64_t utime = 0;
  int32_t seq = 0;
  int64_t scan_id = 0;                 // 0: not for a scan
  std::optional<PixelBox> target_box;  // nothing: no target found
  int32_t target_pixels = 0;
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
  Image view;  // kJpeg
  Image mask;  // kPng, 0 or 255
};

}  // namespace geon::sensor
