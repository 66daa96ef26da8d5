#include "sim/image_sensor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/contracts.h"
#include "sim/gaussian_table.h"
#include "sim/hash_noise.h"

namespace geon::sim {
namespace {

// Each of `count` values in `old_values` keeps 1 - 2 blur of its light and takes a share of blur
// from each of two others.
void Spread(const float* old_values, const float* before, const float* after, size_t count,
            float blur_1, float* values) {
  for (size_t k = 0; k < count; ++k) {
    values[k] = old_values[k] + blur_1 * (before[k] - 2.0F * old_values[k] + after[k]);
  }
}

}  // namespace

void BlurByLens(int width_px, int height_px, int channels, double blur_1,
                std::vector<float>* light) {
  const auto width = static_cast<size_t>(width_px), height = static_cast<size_t>(height_px),
             depth = static_cast<size_t>(channels);
  Require(light->size() == width * height * depth, "BlurByLens: the image has another size");
  const auto blur = static_cast<float>(blur_1);
  const size_t count = width * depth;
  // The ends repeat: a row between copies of its first and last pixel.
  std::vector<float> padded(count + 2 * depth), before(count), here(count);
  const auto blur_along = [&](float* row) {
    std::copy(row, row + count, padded.begin() + static_cast<std::ptrdiff_t>(depth));
    for (size_t c = 0; c < depth; ++c) {
      padded[c] = row[c];
      padded[depth + count + c] = row[count - depth + c];
    }
    Spread(&padded[depth], &padded[0], &padded[2 * depth], count, blur, row);
  };
  blur_along(light->data());
  before.assign(light->begin(), light->begin() + static_cast<std::ptrdiff_t>(count));
  for (size_t v = 0; v < height; ++v) {
    float* row = light->data() + v * count;
    std::copy(row, row + count, here.begin());
    const float* after = here.data();
    if (v + 1 < height) {
      blur_along(row + count);
      after = row + count;
    }
    Spread(here.data(), before.data(), after, count, blur, row);
    std::swap(before, here);
  }
}

ImageSensor::ImageSensor(const CameraOptions& options)
    : black_level_1_(static_cast<float>(options.black_level_1)),
      shot_noise2_1_(static_cast<float>(1.0 / options.full_well_e)),
      read_noise2_1_(static_cast<float>(std::pow(options.read_noise_e / options.full_well_e, 2))),
      value_(kSteps) {
  for (size_t k = 0; k < kSteps; ++k) {
    const double level_1 = static_cast<double>(k) / static_cast<double>(kSteps - 1);
    value_[k] = static_cast<uint8_t>(std::lround(255.0 * std::pow(level_1, 1.0 / options.gamma_1)));
  }
}

std::vector<uint8_t> ImageSensor::Expose(std::span<const float> signal, uint64_t noise_seed) const {
  const float* gaussian = GaussianTable::Table().data();
  constexpr auto kTop = static_cast<float>(kSteps - 1);
  std::vector<uint8_t> pixels(signal.size());
  // Look-ups and arithmetic apart, a block at a time, so that the arithmetic is done in vectors.
  constexpr size_t kBlock = 256;
  float noise[kBlock];
  int32_t step[kBlock];
  for (size_t start = 0; start < signal.size(); start += kBlock) {
    const size_t count = std::min(kBlock, signal.size() - start);
    for (size_t k = 0; k < kBlock; k += 4) {
      const uint64_t bits = HashMix(noise_seed + start + k);
      noise[k] = gaussian[bits & 0xffffU];
      noise[k + 1] = gaussian[bits >> 16U & 0xffffU];
      noise[k + 2] = gaussian[bits >> 32U & 0xffffU];
      noise[k + 3] = gaussian[bits >> 48U];
    }
    const float* light = &signal[start];
    for (size_t k = 0; k < count; ++k) {
      const float clean = std::max(0.0F, std::min(1.0F, light[k]));
      const float sigma = std::sqrt(clean * shot_noise2_1_ + read_noise2_1_);
      const float noisy = light[k] + black_level_1_ + sigma * noise[k];
      step[k] = static_cast<int32_t>(std::max(0.5F, std::min(kTop + 0.5F, noisy * kTop + 0.5F)));
    }
    for (size_t k = 0; k < count; ++k) pixels[start + k] = value_[static_cast<size_t>(step[k])];
  }
  return pixels;
}

}  // namespace geon::sim
