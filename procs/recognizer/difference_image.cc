#include "procs/recognizer/difference_image.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>

namespace geon::recognizer {
namespace {

constexpr size_t kPngHeaderBytes = 24;  // signature, chunk length, "IHDR", width, height

int BigEndian(const std::vector<uint8_t>& bytes, size_t at) {
  return static_cast<int>((uint32_t{bytes[at]} << 24U) | (uint32_t{bytes[at + 1]} << 16U) |
                          (uint32_t{bytes[at + 2]} << 8U) | uint32_t{bytes[at + 3]});
}

std::string Size(int width_px, int height_px) {
  return std::to_string(width_px) + " x " + std::to_string(height_px);
}

// Looks at the size before anything is decompressed: a few bytes may claim to be a huge picture.
Status CheckPngSize(const std::vector<uint8_t>& png, int width_px, int height_px) {
  if (png.size() < kPngHeaderBytes) return Status::Error("difference image: no PNG, too short");
  const int width = BigEndian(png, 16);
  const int height = BigEndian(png, 20);
  if (width == width_px && height == height_px) return Status::Ok();
  return Status::Error("difference image: PNG of " + Size(width, height) + " pixels instead of " +
                       Size(width_px, height_px));
}

}  // namespace

Result<sensor::Image> DifferenceImage(const sensor::Image& image, int width_px, int height_px) {
  if (image.format == sensor::PixelFormat::kGray8) {
    const size_t bytes = static_cast<size_t>(std::max(image.row_stride_bytes, 0)) *
                         static_cast<size_t>(std::max(image.height_px, 0));
    if (image.width_px != width_px || image.height_px != height_px ||
        image.row_stride_bytes < image.width_px || image.data.size() < bytes) {
      return Status::Error("difference image: " + Size(image.width_px, image.height_px) +
                           " pixels instead of " + Size(width_px, height_px));
    }
    return image;
  }
  if (image.format != sensor::PixelFormat::kPng) {
    return Status::Error("difference image: neither grey levels nor PNG");
  }
  if (Status status = CheckPngSize(image.data, width_px, height_px); !status.ok()) return status;
  cv::Mat pixels;
  try {
    pixels = cv::imdecode(image.data, cv::IMREAD_GRAYSCALE);
  } catch (const cv::Exception& error) {
    return Status::Error("difference image: " + error.msg);
  }
  if (pixels.cols != width_px || pixels.rows != height_px || !pixels.isContinuous()) {
    return Status::Error("difference image: the PNG is damaged");
  }
  sensor::Image plain = image;
  plain.format = sensor::PixelFormat::kGray8;
  plain.width_px = width_px;
  plain.height_px = height_px;
  plain.row_stride_bytes = width_px;
  plain.data.assign(pixels.datastart, pixels.dataend);
  return plain;
}

}  // namespace geon::recognizer
