#pragma once

#include <vector>

#include "base/status.h"
#include "geometry/pinhole_camera.h"
#include "sensor/image.h"

namespace geon::planner {

// A camera's picture as kBgr8 or kRgb8, whichever way it came over the bus. An error when it is
// damaged, has no colour, or has not the size of the camera that the rig states.
Result<sensor::Image> DecodeColor(const sensor::Image& image,
                                  const geometry::PinholeCamera& camera);

// A picture in colour as kJpeg; time and number stay.
sensor::Image EncodeJpeg(const sensor::Image& image, int quality);

// A mask of 0 and 255, width x height, as kPng.
sensor::Image EncodeMask(const std::vector<uint8_t>& mask, int width_px, int height_px);

}  // namespace geon::planner
