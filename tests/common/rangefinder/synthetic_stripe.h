#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>

#include "sensor/image.h"
#include "sensor/stripe.h"

namespace geon::rangefinder {

// An image of one stripe with a Gaussian profile, each pixel collecting the light that falls on it.
struct SyntheticStripe {
  int width_px = 640;
  int height_px = 480;
  sensor::Laser laser = sensor::Laser::kHorizontal;
  double amplitude_1 = 180.0;
  double stripe_px = 2.0;  // standard deviation of the profile
  double background_1 = 6.0;
  double noise_1 = 3.0;      // of every pixel, as a camera reads it
  double gain_1 = 0.0;       // grey levels of variance for every one of light: shot noise
  bool minus_unlit = false;  // less a frame without the laser, cut off at 0
  unsigned seed = 1;
  // Where the stripe lies in a column (row); nothing where there is none.
  std::function<std::optional<double>(int line)> position_px;

  sensor::Image Render() const {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    sensor::Image image;
    image.width_px = width_px;
    image.height_px = height_px;
    image.row_stride_bytes = width_px;
    image.format = sensor::PixelFormat::kGray8;
    image.data.resize(static_cast<size_t>(width_px * height_px));
    const bool horizontal = laser == sensor::Laser::kHorizontal;
    const int lines = horizontal ? width_px : height_px;
    const int length = horizontal ? height_px : width_px;
    for (int line = 0; line < lines; ++line) {
      const std::optional<double> center_px = position_px(line);
      for (int i = 0; i < length; ++i) {
        double level = background_1;
        if (center_px && std::abs(i - *center_px) < 8.0 * stripe_px + 1.0) {
          // The mean over the pixel of exp(-x^2 / 2 sigma^2).
          const auto integral = [&](double x) {
            return std::erf((x - *center_px) / (std::sqrt(2.0) * stripe_px));
          };
          level += amplitude_1 * stripe_px * std::sqrt(std::acos(-1.0) / 2.0) *
                   (integral(i + 0.5) - integral(i - 0.5));
        }
        level += std::sqrt(noise_1 * noise_1 + gain_1 * level) * noise(random);
        const auto index =
            static_cast<size_t>(horizontal ? i * width_px + line : line * width_px + i);
        image.data[index] = Digitized(level);
        if (minus_unlit) {
          const double unlit =
              background_1 + std::sqrt(noise_1 * noise_1 + gain_1 * background_1) * noise(random);
          image.data[index] =
              static_cast<uint8_t>(std::max(0, image.data[index] - Digitized(unlit)));
        }
      }
    }
    return image;
  }

 private:
  static uint8_t Digitized(double level) {
    return static_cast<uint8_t>(std::clamp(std::lround(level), 0L, 255L));
  }
};

}  // namespace geon::rangefinder
