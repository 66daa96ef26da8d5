#pragma once

#include <random>
#include <utility>
#include <vector>

#include "attention/color_model.h"
#include "sensor/image.h"

namespace geon::attention {

// Segmentation written once more, a pixel at a time and with flood fill: what the fast one must
// equal.
struct NaiveBlob {
  std::vector<std::pair<int, int>> pixels;  // (u, v), row by row
};
struct NaiveSegmentation {
  std::vector<ColorClass> classes;  // width x height
  std::vector<bool> target;         // resolved
  std::vector<bool> eroded;
  std::vector<NaiveBlob> blobs;  // of the eroded ones, by their first pixel
};
NaiveSegmentation SegmentNaively(const sensor::Image& image, const ColorModel& model,
                                 int erosion_neighbors);

// Pictures and models to compare on.
sensor::Image RandomImage(int width_px, int height_px, sensor::PixelFormat format,
                          std::mt19937& random);
// Regions of half-spaces with whole, small coefficients, as learned ones are; else any.
ColorModel RandomModel(bool whole_numbered, std::mt19937& random);

}  // namespace geon::attention
