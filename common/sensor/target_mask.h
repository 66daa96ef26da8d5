#pragma once

#include <cstdint>
#include <vector>

#include "sensor/image.h"

namespace geon::sensor {

// Which pixels of a colour picture show the target of a scan.
struct TargetMask {
  int64_t utime = 0;
  int32_t seq = 0;
  int64_t scan_id = 0;
  PixelBox box;          // of the target; nothing outside belongs to it
  double pan_rad = 0.0;  // head when the picture was taken
  double tilt_rad = 0.0;
  // The box row by row, as lengths of runs: background first, then target, and so on by turns. A
  // run longer than 32767 goes on after one of length 0. Together they fill the box.
  std::vector<int16_t> runs_px;
};

}  // namespace geon::sensor
