#include "rangefinder/laser_light.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "base/contracts.h"

namespace geon::rangefinder {
namespace {

using sensor::PixelFormat;

void RequireReadable(const sensor::Image& image) {
  const int channels = sensor::ChannelCount(image.format);
  Require(channels > 0, "LaserLight: an uncompressed image is needed");
  Require(image.width_px > 0 && image.height_px > 0 &&
              image.row_stride_bytes >= channels * image.width_px &&
              image.data.size() >= static_cast<size_t>(image.row_stride_bytes) *
                                       static_cast<size_t>(image.height_px),
          "LaserLight: the image's data does not fit its size");
}

// The image's pixels without copying; never written to.
cv::Mat View(const sensor::Image& image) {
  RequireReadable(image);
  const int type = sensor::ChannelCount(image.format) == 1 ? CV_8UC1 : CV_8UC3;
  return {image.height_px, image.width_px, type, const_cast<uint8_t*>(image.data.data()),
          static_cast<size_t>(image.row_stride_bytes)};
}

sensor::Image GrayImage(const cv::Mat& gray, const sensor::Image& source) {
  sensor::Image image;
  image.utime = source.utime;
  image.seq = source.seq;
  image.width_px = gray.cols;
  image.height_px = gray.rows;
  image.row_stride_bytes = gray.cols;
  image.format = PixelFormat::kGray8;
  image.data.reserve(gray.total());
  for (int v = 0; v < gray.rows; ++v) {
    image.data.insert(image.data.end(), gray.ptr<uint8_t>(v), gray.ptr<uint8_t>(v) + gray.cols);
  }
  return image;
}

cv::Mat Channel(const cv::Mat& pixels, int channel) {
  cv::Mat plane;
  cv::extractChannel(pixels, plane, channel);
  return plane;
}

cv::Mat Mean(const cv::Mat& pixels) {
  cv::Mat mean;
  cv::transform(pixels, mean, cv::Matx13f(1.0F / 3.0F, 1.0F / 3.0F, 1.0F / 3.0F));
  return mean;
}

int ChannelIndex(PixelFormat format, LaserColor color) {
  if (color == LaserColor::kGreen) return 1;
  return format == PixelFormat::kRgb8 ? 0 : 2;
}

// The channel the laser shines in.
cv::Mat LaserChannel(const sensor::Image& image, LaserColor color) {
  const cv::Mat pixels = View(image);
  if (pixels.channels() == 1) return pixels;
  if (color == LaserColor::kMono) return Mean(pixels);
  return Channel(pixels, ChannelIndex(image.format, color));
}

// The mean of the two channels the laser does not shine in.
cv::Mat OtherChannels(const sensor::Image& image, LaserColor color) {
  const cv::Mat pixels = View(image);
  const int laser_channel = ChannelIndex(image.format, color);
  cv::Mat weights(1, 3, CV_32F, cv::Scalar(0.5));
  weights.at<float>(0, laser_channel) = 0.0F;
  cv::Mat mean;
  cv::transform(pixels, mean, weights);
  return mean;
}

cv::Mat LocalBackground(const cv::Mat& plane, int window_px) {
  // The median of a window no larger than the image, which must be odd.
  int window = std::min({window_px, plane.cols, plane.rows});
  if (window % 2 == 0) --window;
  cv::Mat background;
  cv::medianBlur(plane, background, std::max(window, 1));
  return background;
}

}  // namespace

sensor::Image LaserLight(const sensor::Image& lit, const sensor::Image& unlit, LaserColor color) {
  Require(lit.width_px == unlit.width_px && lit.height_px == unlit.height_px &&
              lit.format == unlit.format,
          "LaserLight: the lit and the unlit image differ in size or format");
  cv::Mat light;
  cv::subtract(LaserChannel(lit, color), LaserChannel(unlit, color), light);
  return GrayImage(light, lit);
}

sensor::Image LaserLight(const sensor::Image& lit, LaserColor color,
                         const LaserLightOptions& options) {
  Require(options.background_window_px >= 3, "LaserLightOptions: background_window_px at least 3");
  cv::Mat light = LaserChannel(lit, color).clone();
  const bool in_color = sensor::ChannelCount(lit.format) == 3 && color != LaserColor::kMono;
  if (in_color) {
    const cv::Mat others = OtherChannels(lit, color);
    cv::Mat surroundings = LocalBackground(others, options.background_window_px);
    surroundings = cv::min(surroundings, others);
    const cv::Mat saturated = light >= options.saturated_level;
    cv::Mat not_laser = others.clone();
    surroundings.copyTo(not_laser, saturated);
    cv::subtract(light, not_laser, light);
  }
  cv::Mat excess;
  cv::subtract(light, LocalBackground(light, options.background_window_px), excess);
  return GrayImage(excess, lit);
}

sensor::Image AverageImages(const std::vector<sensor::Image>& images) {
  Require(!images.empty(), "AverageImages: no images");
  const sensor::Image& first = images.front();
  Require(first.format == PixelFormat::kGray8, "AverageImages: grey images are needed");
  cv::Mat sum(first.height_px, first.width_px, CV_32SC1, cv::Scalar(0));
  for (const sensor::Image& image : images) {
    Require(image.width_px == first.width_px && image.height_px == first.height_px &&
                image.format == first.format,
            "AverageImages: the images differ in size or format");
    cv::add(sum, View(image), sum, cv::noArray(), CV_32S);
  }
  cv::Mat mean;
  sum.convertTo(mean, CV_8U, 1.0 / static_cast<double>(images.size()));
  return GrayImage(mean, first);
}

}  // namespace geon::rangefinder
