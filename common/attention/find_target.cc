#include "attention/find_target.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "attention/resolve_color.h"
#include "attention/rgb_image.h"

namespace geon::attention {
namespace {

cv::Mat SegmentByColor(const RgbImage& image, const ColorModel& model) {
  cv::Mat1b classes(image.height_px(), image.width_px());
  for (int v = 0; v < image.height_px(); ++v) {
    for (int u = 0; u < image.width_px(); ++u) {
      classes(v, u) = static_cast<uint8_t>(model.Classify(image.At(u, v)));
    }
  }
  return ResolveColor(classes);
}

void Erode(const AttentionOptions& options, cv::Mat* mask) {
  const int shape = options.erosion_neighbors == 8 ? cv::MORPH_RECT : cv::MORPH_CROSS;
  const cv::Mat neighbors = cv::getStructuringElement(shape, {3, 3});
  // Beyond the border counts as foreground: see AttentionOptions.
  cv::erode(*mask, *mask, neighbors, {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(255));
}

// All blobs, largest first, and for each of them its label in `labels`.
std::vector<std::pair<Blob, int>> FindBlobs(const cv::Mat& mask, cv::Mat* labels) {
  cv::Mat statistics;
  cv::Mat centers;
  const int count = cv::connectedComponentsWithStats(mask, *labels, statistics, centers, 8, CV_32S);
  std::vector<std::pair<Blob, int>> blobs;
  for (int label = 1; label < count; ++label) {
    const int* box = statistics.ptr<int>(label);
    const double* center = centers.ptr<double>(label);
    blobs.push_back({{{box[cv::CC_STAT_LEFT], box[cv::CC_STAT_TOP], box[cv::CC_STAT_WIDTH],
                       box[cv::CC_STAT_HEIGHT]},
                      box[cv::CC_STAT_AREA],
                      {center[0], center[1]}},
                     label});
  }
  std::stable_sort(blobs.begin(), blobs.end(),
                   [](const auto& a, const auto& b) { return a.first.pixels > b.first.pixels; });
  return blobs;
}

// The middle of the target's lowest row of pixels.
Eigen::Vector2d BottomPoint(const cv::Mat& labels, int label, const sensor::PixelBox& box) {
  const int v = box.v_px + box.h_px - 1;
  const int* row = labels.ptr<int>(v);
  double sum = 0.0;
  int count = 0;
  for (int u = box.u_px; u < box.u_px + box.w_px; ++u) {
    if (row[u] != label) continue;
    sum += u;
    ++count;
  }
  return {sum / count, static_cast<double>(v)};
}

int CountClipped(const RgbImage& image, const sensor::PixelBox& box, int clipped_level) {
  int count = 0;
  for (int v = box.v_px; v < box.v_px + box.h_px; ++v) {
    for (int u = box.u_px; u < box.u_px + box.w_px; ++u) {
      const Rgb pixel = image.At(u, v);
      if (std::max({pixel.red, pixel.green, pixel.blue}) >= clipped_level) ++count;
    }
  }
  return count;
}

}  // namespace

std::optional<std::string> AttentionOptions::Validate() const {
  if (erosion_neighbors != 4 && erosion_neighbors != 8) {
    return "erosion_neighbors is " + std::to_string(erosion_neighbors) + ", must be 4 or 8";
  }
  if (min_target_pixels < 1) {
    return "min_target_pixels is " + std::to_string(min_target_pixels) + ", must be at least 1";
  }
  if (clipped_level < 1 || clipped_level > 255) {
    return "clipped_level is " + std::to_string(clipped_level) + ", must be 1 ... 255";
  }
  return std::nullopt;
}

TargetSighting FindTarget(const sensor::Image& image, const ColorModel& model,
                          const AttentionOptions& options) {
  const std::optional<std::string> error = options.Validate();
  Require(!error, "AttentionOptions: " + error.value_or(""));
  const std::optional<std::string> model_error = model.Validate();
  Require(!model_error, "ColorModel: " + model_error.value_or(""));
  const RgbImage pixels(image);

  TargetSighting sighting;
  sighting.width_px = image.width_px;
  sighting.height_px = image.height_px;

  cv::Mat mask = SegmentByColor(pixels, model);  // 4.1.2
  sighting.color_pixels = cv::countNonZero(mask);
  Erode(options, &mask);  // 4.2.1
  cv::Mat labels;
  const auto blobs = FindBlobs(mask, &labels);
  for (const auto& [blob, label] : blobs) sighting.blobs.push_back(blob);

  sighting.mask.assign(static_cast<size_t>(image.width_px) * static_cast<size_t>(image.height_px),
                       0);
  if (blobs.empty() || blobs.front().first.pixels < options.min_target_pixels) return sighting;
  const auto& [target, target_label] = blobs.front();
  const sensor::PixelBox& box = target.box;
  sighting.target = target;
  std::transform(
      labels.begin<int>(), labels.end<int>(), sighting.mask.begin(),
      [wanted = target_label](int label) -> uint8_t { return label == wanted ? 255 : 0; });
  sighting.bottom_px = BottomPoint(labels, target_label, box);
  sighting.touched = {box.u_px == 0, box.u_px + box.w_px == image.width_px, box.v_px == 0,
                      box.v_px + box.h_px == image.height_px};
  sighting.clipped_pixels = CountClipped(pixels, box, options.clipped_level);
  return sighting;
}

}  // namespace geon::attention
