#pragma once

#include "base/status.h"
#include "sensor/image.h"

namespace geon::recognizer {

// The difference image of a stripe as plain grey levels, decompressed where it came as PNG. An
// error for anything that is not a grey image of this size.
Result<sensor::Image> DifferenceImage(const sensor::Image& image, int width_px, int height_px);

}  // namespace geon::recognizer
