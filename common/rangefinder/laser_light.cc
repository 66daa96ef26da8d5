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

// The brighter of the two channels the laser does not shine in: to a red laser's light yellow paint
// is no more alike than white.
cv::Mat BrighterOther(const sensor::Image& image, LaserColor color) {
  const cv::Mat pixels = View(image);
  const int laser_channel = ChannelIndex(image.format, color);
  return cv::max(Channel(pixels, (laser_channel + 1) % 3),
                 Channel(pixels, (laser_channel + 2) % 3));
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

constexpr int kGateWindow_px = 7;
constexpr double kFadeIn = 40.0;         // grey levels
constexpr double kLeastTintNoise = 2.0;  // grey levels

// The middle of all values, and how far one standard deviation lies above it.
std::pair<double, double> MedianAndNoise(const cv::Mat& values) {
  std::vector<float> sorted(values.begin<float>(), values.end<float>());
  const auto quantile = [&](double share) {
    const auto at =
        sorted.begin() + static_cast<ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), at, sorted.end());
    return static_cast<double>(*at);
  };
  const double median = quantile(0.5);
  return {median, quantile(0.8413) - median};
}

cv::Mat LocalBackground(const cv::Mat& plane, int window_px) {
  // The median of a window no larger than the image, which must be odd.
  int window = std::min({window_px, plane.cols, plane.rows});
  if (window % 2 == 0) --window;
  cv::Mat background;
  cv::medianBlur(plane, background, std::max(window, 1));
  return background;
}

// The laser's channel above the others, where it is more than usual nearby. In the stripe's
// saturated core all channels are full, which hides its colour: there the others count as in the
// surroundings.
cv::Mat Tint(const sensor::Image& lit, LaserColor color, const LaserLightOptions& options) {
  const cv::Mat laser = LaserChannel(lit, color);
  cv::Mat others = BrighterOther(lit, color);
  const cv::Mat surroundings =
      cv::min(LocalBackground(others, options.background_window_px), others);
  surroundings.copyTo(others, laser >= options.saturated_level);
  cv::Mat tint;
  cv::subtract(laser, others, tint);
  cv::subtract(tint, LocalBackground(tint, options.background_window_px), tint);
  return tint;
}

// Brightness of the laser's light beyond what its own channel can show: where that is full, the
// others, which then catch the overflow, count with it. Half scale, so that both fit.
cv::Mat ColorLevel(const sensor::Image& lit, LaserColor color, const LaserLightOptions& options) {
  const cv::Mat laser = LaserChannel(lit, color);
  cv::Mat overflow = OtherChannels(lit, color);
  // Fades in below full, so that noise there does not make steps.
  cv::Mat share;
  laser.convertTo(share, CV_32F, 1.0 / kFadeIn, 1.0 - options.saturated_level / kFadeIn);
  share = cv::max(cv::min(share, 1.0), 0.0);
  cv::multiply(overflow, share, overflow, 1.0, CV_8U);
  cv::Mat level;
  cv::addWeighted(laser, 0.5, overflow, 0.5, 0.0, level);
  return level;
}

// How much a neighbourhood has the laser's colour, 0 ... 1, against the image's noise. Colour is
// noisy, and coarser than brightness in compressed images: it tells where the laser shines, not to
// a fraction of a pixel.
cv::Mat ColorGate(const cv::Mat& tint) {
  cv::Mat smooth;
  cv::boxFilter(tint, smooth, CV_32F, {kGateWindow_px, kGateWindow_px});
  const auto [median, noise] = MedianAndNoise(smooth);
  // Nothing at 3 standard deviations, all at 6.
  const double unit = 3.0 * std::max(noise, kLeastTintNoise);
  cv::Mat gate = (smooth - (median + unit)) / unit;
  gate = cv::max(cv::min(gate, 1.0), 0.0);
  return gate;
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
  const bool in_color = sensor::ChannelCount(lit.format) == 3 && color != LaserColor::kMono;
  const cv::Mat level = in_color ? ColorLevel(lit, color, options) : LaserChannel(lit, color);
  cv::Mat light;
  cv::subtract(level, LocalBackground(level, options.background_window_px), light);
  if (in_color) cv::multiply(light, ColorGate(Tint(lit, color, options)), light, 1.0, CV_8U);
  return GrayImage(light, lit);
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
