#pragma once

#include "attention/color_space.h"
#include "base/contracts.h"
#include "sensor/image.h"

namespace geon::attention {

// Source: thesis section 4.1.1, the RGB representation of an image.
//
// Read access to the pixels of a kRgb8 or kBgr8 image, whichever way its channels are ordered.
// Throws ContractViolation for other formats and for data that does not fit the size. The image
// must outlive it.
class RgbImage {
 public:
  explicit RgbImage(const sensor::Image& image) : image_(image) {
    Require(sensor::ChannelCount(image.format) == 3, "A colour image (rgb8 or bgr8) is needed");
    Require(image.width_px > 0 && image.height_px > 0 &&
                image.row_stride_bytes >= 3 * image.width_px &&
                image.data.size() >= static_cast<size_t>(image.row_stride_bytes) *
                                         static_cast<size_t>(image.height_px),
            "The image's data does not fit its size");
    red_ = image.format == sensor::PixelFormat::kRgb8 ? 0 : 2;
  }
  int width_px() const { return image_.width_px; }
  int height_px() const { return image_.height_px; }
  Rgb At(int u_px, int v_px) const {
    const uint8_t* pixel =
        image_.data.data() +
        static_cast<size_t>(v_px) * static_cast<size_t>(image_.row_stride_bytes) +
        3U * static_cast<size_t>(u_px);
    return {pixel[red_], pixel[1], pixel[2 - red_]};
  }

 private:
  const sensor::Image& image_;
  size_t red_ = 0;
};

}  // namespace geon::attention
