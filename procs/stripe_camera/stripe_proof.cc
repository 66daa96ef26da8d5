#include "procs/stripe_camera/stripe_proof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "base/contracts.h"

namespace geon::stripe_camera {
namespace {

constexpr int kLevels = 256;

// Counts of the values -255..255.
using Histogram = std::array<int64_t, 2 * kLevels - 1>;

Histogram CountValues(const std::vector<int16_t>& values) {
  Histogram histogram{};
  for (const int16_t value : values) ++histogram[static_cast<size_t>(value + kLevels - 1)];
  return histogram;
}

int MedianValue(const Histogram& histogram, size_t count) {
  int64_t below = 0;
  for (size_t i = 0; i < histogram.size(); ++i) {
    below += histogram[i];
    if (2 * below >= static_cast<int64_t>(count)) return static_cast<int>(i) - (kLevels - 1);
  }
  return 0;
}

// Standard deviation about `center` of what lies within four of itself: the stripe stays out. Grey
// levels are too coarse for a median of deviations alone.
double ClippedDeviation(const Histogram& histogram, int center) {
  double deviation = kLevels;
  for (int round = 0; round < 6; ++round) {
    double sum = 0.0;
    int64_t count = 0;
    for (size_t i = 0; i < histogram.size(); ++i) {
      const double offset = static_cast<int>(i) - (kLevels - 1) - center;
      if (std::abs(offset) > std::max(4.0 * deviation, 1.0)) continue;
      sum += offset * offset * static_cast<double>(histogram[i]);
      count += histogram[i];
    }
    deviation = count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count));
  }
  return deviation;
}

int CountAbove(const std::vector<int>& values, double threshold) {
  return static_cast<int>(
      std::count_if(values.begin(), values.end(), [&](int value) { return value >= threshold; }));
}

// Largest level that at least `count` of the values reach; 0 when there are not so many.
double ReachedBy(std::vector<int> values, int count) {
  if (static_cast<int>(values.size()) < count) return 0.0;
  const auto nth = values.begin() + (count - 1);
  std::nth_element(values.begin(), nth, values.end(), std::greater<>());
  return std::max(*nth, 0);
}

}  // namespace

void FrameSum::Add(const sensor::Image& grey) {
  Require(grey.format == sensor::PixelFormat::kGray8, "FrameSum: the frame must be grey");
  const auto width = static_cast<size_t>(grey.width_px);
  if (count_ == 0) {
    width_px_ = grey.width_px;
    height_px_ = grey.height_px;
    sum_.assign(width * static_cast<size_t>(grey.height_px), 0);
  }
  Require(grey.width_px == width_px_ && grey.height_px == height_px_,
          "FrameSum: frames differ in size");
  for (size_t row = 0; row < static_cast<size_t>(height_px_); ++row) {
    const uint8_t* from = &grey.data[row * static_cast<size_t>(grey.row_stride_bytes)];
    for (size_t column = 0; column < width; ++column) sum_[row * width + column] += from[column];
  }
  ++count_;
}

void FrameSum::Clear() {
  sum_.clear();
  count_ = 0;
}

std::vector<int16_t> FrameSum::MeanDifference(const FrameSum& lit) const {
  Require(count_ > 0 && lit.count_ > 0 && sum_.size() == lit.sum_.size(),
          "FrameSum: nothing to compare");
  std::vector<int16_t> difference(sum_.size());
  for (size_t i = 0; i < sum_.size(); ++i) {
    const double mean =
        static_cast<double>(lit.sum_[i]) / lit.count_ - static_cast<double>(sum_[i]) / count_;
    difference[i] = static_cast<int16_t>(std::lround(mean));
  }
  return difference;
}

std::vector<int16_t> AboveMedian(const sensor::Image& grey) {
  Require(grey.format == sensor::PixelFormat::kGray8, "AboveMedian: the frame must be grey");
  const auto width = static_cast<std::ptrdiff_t>(grey.width_px);
  std::vector<int16_t> levels;
  levels.reserve(static_cast<size_t>(width * grey.height_px));
  for (std::ptrdiff_t row = 0; row < grey.height_px; ++row) {
    const auto from = grey.data.begin() + row * grey.row_stride_bytes;
    levels.insert(levels.end(), from, from + width);
  }
  const int median = MedianValue(CountValues(levels), levels.size());
  for (int16_t& level : levels) level = static_cast<int16_t>(level - median);
  return levels;
}

StripeProof ProveStripe(const std::vector<int16_t>& difference, int width_px, int height_px,
                        sensor::Laser laser, const StripeProofOptions& options) {
  Require(laser != sensor::Laser::kNone, "ProveStripe: no laser");
  Require(difference.size() == static_cast<size_t>(width_px) * static_cast<size_t>(height_px),
          "ProveStripe: the difference is not width x height");
  const Histogram histogram = CountValues(difference);
  const int everywhere = MedianValue(histogram, difference.size());
  StripeProof proof;
  proof.noise_level = ClippedDeviation(histogram, everywhere);

  std::vector<int> column_peaks(static_cast<size_t>(width_px), -kLevels);
  std::vector<int> row_peaks(static_cast<size_t>(height_px), -kLevels);
  for (size_t row = 0, i = 0; row < row_peaks.size(); ++row) {
    for (size_t column = 0; column < column_peaks.size(); ++column, ++i) {
      const int level = difference[i] - everywhere;
      column_peaks[column] = std::max(column_peaks[column], level);
      row_peaks[row] = std::max(row_peaks[row], level);
    }
  }
  const double threshold =
      std::max(options.min_peak_level, options.min_peak_to_noise_1 * proof.noise_level);
  proof.lit_columns = CountAbove(column_peaks, threshold);
  proof.lit_rows = CountAbove(row_peaks, threshold);
  const bool horizontal = laser == sensor::Laser::kHorizontal;
  const int along = horizontal ? proof.lit_columns : proof.lit_rows;
  const int across = horizontal ? proof.lit_rows : proof.lit_columns;
  proof.peak_level = ReachedBy(horizontal ? column_peaks : row_peaks, options.min_lit_lines);
  if (along < options.min_lit_lines) {
    proof.reason = "no stripe: only " + std::to_string(along) + " lines are lit";
  } else if (across >= along) {
    proof.reason = "the light does not lie as this laser's stripe: " + std::to_string(along) +
                   " lines along it, " + std::to_string(across) + " across";
  }
  proof.lit = proof.reason.empty();
  return proof;
}

sensor::Image SaturatedDifference(const std::vector<int16_t>& difference, int width_px,
                                  int height_px) {
  sensor::Image image;
  image.width_px = width_px;
  image.height_px = height_px;
  image.row_stride_bytes = width_px;
  image.format = sensor::PixelFormat::kGray8;
  image.data.resize(difference.size());
  std::transform(difference.begin(), difference.end(), image.data.begin(), [](int16_t value) {
    return static_cast<uint8_t>(std::clamp<int>(value, 0, kLevels - 1));
  });
  return image;
}

}  // namespace geon::stripe_camera
