#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/camera_options.h"

namespace geon::sim {

// Spreads each pixel's light to its neighbours as the lens does; `channels` interleaved values a
// pixel.
void BlurByLens(int width_px, int height_px, int channels, double blur_1,
                std::vector<float>* light);

// The chip and its electronics.
class ImageSensor {
 public:
  explicit ImageSensor(const CameraOptions& options);

  // From light (signal in units of full scale, any number of channels) to pixel values: shot and
  // read noise, black level, saturation, gamma, 8 bits. `noise_seed` names the frame.
  std::vector<uint8_t> Expose(std::span<const float> signal, uint64_t noise_seed) const;

 private:
  static constexpr size_t kSteps = 16384;  // fine enough for the steep foot of the gamma curve
  float black_level_1_;
  float shot_noise2_1_;         // variance of the noise at full scale
  float read_noise2_1_;         // variance of the noise in the dark
  std::vector<uint8_t> value_;  // pixel value of each of kSteps levels
};

}  // namespace geon::sim
