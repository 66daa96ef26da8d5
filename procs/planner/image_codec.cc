#include "procs/planner/image_codec.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/contracts.h"

namespace geon::planner {

namespace {

sensor::Image WithoutPixels(const sensor::Image& image) {
  sensor::Image copy;
  copy.utime = image.utime;
  copy.seq = image.seq;
  copy.width_px = image.width_px;
  copy.height_px = image.height_px;
  copy.exposure_s = image.exposure_s;
  return copy;
}

Result<sensor::Image> Decompress(const sensor::Image& image) {
  cv::Mat bgr;
  try {
    bgr = cv::imdecode(image.data, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception& error) {
    return Status::Error(std::string("a picture cannot be decoded: ") + error.what());
  }
  if (bgr.empty()) return Status::Error("a picture cannot be decoded");
  sensor::Image decoded = WithoutPixels(image);
  decoded.format = sensor::PixelFormat::kBgr8;
  decoded.width_px = bgr.cols;
  decoded.height_px = bgr.rows;
  decoded.row_stride_bytes = 3 * bgr.cols;
  decoded.data.assign(bgr.datastart, bgr.dataend);
  return decoded;
}

std::string SizeText(int width_px, int height_px) {
  return std::to_string(width_px) + "x" + std::to_string(height_px);
}

}  // namespace

Result<sensor::Image> DecodeColor(const sensor::Image& image,
                                  const geometry::PinholeCamera& camera) {
  const bool compressed =
      image.format == sensor::PixelFormat::kJpeg || image.format == sensor::PixelFormat::kPng;
  Result<sensor::Image> decoded = compressed ? Decompress(image) : Result<sensor::Image>(image);
  if (!decoded.ok()) return decoded;
  if (sensor::ChannelCount(decoded->format) != 3) {
    return Status::Error("a picture without colour came from a colour camera");
  }
  if (decoded->width_px != camera.width_px || decoded->height_px != camera.height_px) {
    return Status::Error("a picture of " + SizeText(decoded->width_px, decoded->height_px) +
                         " came from a camera whose rig says " +
                         SizeText(camera.width_px, camera.height_px));
  }
  if (decoded->row_stride_bytes < 3 * decoded->width_px ||
      decoded->data.size() < static_cast<size_t>(decoded->row_stride_bytes) *
                                 static_cast<size_t>(decoded->height_px)) {
    return Status::Error("a picture has fewer bytes than its size needs");
  }
  return decoded;
}

sensor::Image EncodeJpeg(const sensor::Image& image, int quality) {
  Require(sensor::ChannelCount(image.format) == 3, "EncodeJpeg: a picture in colour is needed");
  cv::Mat bgr(image.height_px, image.width_px, CV_8UC3, const_cast<uint8_t*>(image.data.data()),
              static_cast<size_t>(image.row_stride_bytes));
  if (image.format == sensor::PixelFormat::kRgb8) cv::cvtColor(bgr, bgr, cv::COLOR_RGB2BGR);
  sensor::Image encoded = WithoutPixels(image);
  encoded.format = sensor::PixelFormat::kJpeg;
  cv::imencode(".jpg", bgr, encoded.data, {cv::IMWRITE_JPEG_QUALITY, quality});
  return encoded;
}

sensor::Image EncodeMask(const std::vector<uint8_t>& mask, int width_px, int height_px) {
  Require(mask.size() == static_cast<size_t>(width_px) * static_cast<size_t>(height_px),
          "EncodeMask: the mask has not the size it is said to have");
  const cv::Mat gray(height_px, width_px, CV_8UC1, const_cast<uint8_t*>(mask.data()));
  sensor::Image encoded;
  encoded.width_px = width_px;
  encoded.height_px = height_px;
  encoded.format = sensor::PixelFormat::kPng;
  cv::imencode(".png", gray, encoded.data);
  return encoded;
}

}  // namespace geon::planner
