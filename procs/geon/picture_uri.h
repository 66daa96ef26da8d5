#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sensor/image.h"

namespace geon::cli {

// A picture (kBgr8) as the data URI of a JPEG, for a page; the mask's regions, if there is a mask,
// outlined in white. `width_px`: smaller than it was taken; 0: as it is. Empty for an empty
// picture.
std::string PictureUri(const sensor::Image& picture, const std::vector<uint8_t>& mask = {},
                       int width_px = 0);

}  // namespace geon::cli
