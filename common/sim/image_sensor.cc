#include "sim/image_sensor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/contracts.h"
#include "sim/gaussian_table.h"
#include "sim/hash_noise.h"

namespace geon::sim {
namespace {

// One pass of (blur, 1 - 2 blur, blur) over `count` values `stride` apart; the ends repeat.
void BlurLine(float* values, size_t count, size_t stride, float blur_1) {
  float before = values[0];
  for (size_t k = 0; k < count; ++k) {
    float* here = values + k * stride;
    const float after = k + 1 < count ? here[stride] : *here;
    const float old = *here;
    *here = old + blur_1 * (before - 2.0F * old + after);
    before = old;
  }
}

}  // namespace

void BlurByLens(int width_px, int height_px, int channels, double blur_1,
                std::vector<float>* light) {
  const auto width = static_cast<size_t>(width_px), height = static_cast<size_t>(height_px),
             depth = static_cast<size_t>(channels);
  Require(light->size() == width * height * depth, "BlurByLens: the image has another size");
  const auto blur = static_cast<float>(blur_1);
  for (size_t v = 0; v < height; ++v) {
    for (size_t c = 0; c < depth; ++c)
      BlurLine(light->data() + v * width * depth + c, width, depth, blur);
  }
  // Row by row, to stay in the cache: all columns advance together.
  std::vector<float> before(light->begin(),
                            light->begin() + static_cast<std::ptrdiff_t>(width * depth));
  for (size_t v = 0; v < height; ++v) {
    float* row = light->data() + v * width * depth;
    const float* next = v + 1 < height ? row + width * depth : row;
    for (size_t k = 0; k < width * depth; ++k) {
      const float old = row[k];
      row[k] = old + blur * (before[k] - 2.0F * old + next[k]);
      before[k] = old;
    }
  }
}

ImageSensor::ImageSensor(const CameraOptions& options)
    : black_level_1_(static_cast<float>(options.black_level_1)), noise_1_(kSteps), value_(kSteps) {
  for (size_t k = 0; k < kSteps; ++k) {
    const double level_1 = static_cast<double>(k) / static_cast<double>(kSteps - 1);
    const double electrons = level_1 * options.full_well_e;
    noise_1_[k] = static_cast<float>(
        std::sqrt(electrons + options.read_noise_e * options.read_noise_e) / options.full_well_e);
    value_[k] = static_cast<uint8_t>(std::lround(255.0 * std::pow(level_1, 1.0 / options.gamma_1)));
  }
}

std::vector<uint8_t> ImageSensor::Expose(std::span<const float> signal, uint64_t noise_seed) const {
  const std::array<float, 65536>& gaussian = GaussianTable::Table();
  constexpr auto kTop = static_cast<float>(kSteps - 1);
  std::vector<uint8_t> pixels(signal.size());
  for (size_t start = 0; start < signal.size(); start += 4) {
    uint64_t bits = HashMix(noise_seed + start);
    const size_t end = std::min(start + 4, signal.size());
    for (size_t k = start; k < end; ++k, bits >>= 16U) {
      const float clean = std::clamp(signal[k], 0.0F, 1.0F);
      const float noisy = signal[k] + black_level_1_ +
                          noise_1_[static_cast<size_t>(clean * kTop)] * gaussian[bits & 0xffffU];
      pixels[k] = value_[static_cast<size_t>(std::clamp(noisy, 0.0F, 1.0F) * kTop + 0.5F)];
    }
  }
  return pixels;
}

}  // namespace geon::sim
