#pragma once

#include <utility>

#include "sensor/image.h"
#include "sim/rig_renderer.h"

namespace geon::lockstep {

// A simulated frame as the robot's programs hold it; when it was taken is the caller's to say.
inline sensor::Image ImageOf(sim::Frame frame) {
  sensor::Image image;
  image.width_px = frame.width_px;
  image.height_px = frame.height_px;
  image.row_stride_bytes = frame.width_px * frame.channels;
  image.format = frame.channels == 1 ? sensor::PixelFormat::kGray8 : sensor::PixelFormat::kBgr8;
  image.data = std::move(frame.pixels);
  return image;
}

}  // namespace geon::lockstep
