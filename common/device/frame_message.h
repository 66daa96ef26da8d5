#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/status.h"
#include "sensor/image.h"

namespace geon::device {

// A frame as it comes over a frame socket, in two parts: a JSON header
//   {"seq":int,"utime":int,"width":int,"height":int,"format":"bgr8"|"gray8","exposure_us":int}
// and the pixels, rows tightly packed. Trusts nothing: keys, types, ranges and the number of bytes.
Result<sensor::Image> ParseFrame(std::string_view header, std::span<const uint8_t> pixels);

}  // namespace geon::device
