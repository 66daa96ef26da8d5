#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/camera_options.h"

namespace geon::sim {

// Spreads each pixel's light to its neighbours as the lens does; `channels` interleaved values a
// pixel.
void BlurByLens(int width_px, int height_px, int channels, double blur_1,
                std::vector<float>* light);

// From light (signal in units of full scale, any number of channels) to pixel values: shot and read
// noise, black level, saturation, gamma, 8 bits. `noise_seed` names the frame.
std::vector<uint8_t> Expose(std::span<const float> signal, const CameraOptions& options,
                            uint64_t noise_seed);

}  // namespace geon::sim
