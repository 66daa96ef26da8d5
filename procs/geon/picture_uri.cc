#include "procs/geon/picture_uri.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "procs/geon/svg.h"

namespace geon::cli {

std::string PictureUri(const sensor::Image& picture, const std::vector<uint8_t>& mask,
                       int width_px) {
  if (picture.data.empty()) return "";
  constexpr int kQuality = 75;
  const cv::Mat seen(picture.height_px, picture.width_px, CV_8UC3,
                     const_cast<uint8_t*>(picture.data.data()),
                     static_cast<size_t>(picture.row_stride_bytes));
  cv::Mat drawn = seen.clone();
  if (!mask.empty()) {
    const cv::Mat regions(drawn.rows, drawn.cols, CV_8UC1, const_cast<uint8_t*>(mask.data()));
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(regions, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    cv::drawContours(drawn, outlines, -1, cv::Scalar(255, 255, 255), 1);
  }
  if (width_px > 0 && width_px < drawn.cols) {
    cv::Mat small;
    cv::resize(drawn, small, cv::Size(width_px, width_px * drawn.rows / drawn.cols), 0, 0,
               cv::INTER_AREA);
    drawn = small;
  }
  std::vector<uint8_t> jpeg;
  cv::imencode(".jpg", drawn, jpeg, {cv::IMWRITE_JPEG_QUALITY, kQuality});
  return DataUri("image/jpeg", jpeg);
}

}  // namespace geon::cli
