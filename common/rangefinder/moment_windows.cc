#include "rangefinder/moment_windows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace geon::rangefinder {
namespace {

class Windows {
 public:
  Windows() {
    for (int k = 0; k < kSigmas; ++k) {
      windows_.push_back(Make(SigmaAt(k), true));
      windows_.push_back(Make(SigmaAt(k), false));
    }
    for (size_t k = 0; k < nearest_.size(); ++k) {
      const double sigma_px = (static_cast<double>(k) + 0.5) / kPerPixel;
      int best = 0;
      for (int j = 1; j < kSigmas; ++j) {
        if (std::abs(std::log(sigma_px / SigmaAt(j))) <
            std::abs(std::log(sigma_px / SigmaAt(best))))
          best = j;
      }
      nearest_[k] = best;
    }
  }
  // The window for a stripe of that width.
  const MomentWindow& For(float sigma_px, bool middle_on_pixel) const {
    const auto k = static_cast<size_t>(
        std::clamp(sigma_px * kPerPixel, 0.0F, static_cast<float>(nearest_.size() - 1)));
    return windows_[static_cast<size_t>(2 * nearest_[k] + (middle_on_pixel ? 0 : 1))];
  }

 private:
  static constexpr int kSigmas = 20;
  static constexpr float kPerPixel = 8.0F;
  static double SigmaAt(int k) { return 0.7 * std::pow(1.15, k); }  // to 10 px

  static MomentWindow Make(double sigma_px, bool middle_on_pixel) {
    MomentWindow window;
    window.sigma_px = static_cast<float>(sigma_px);
    window.reach = static_cast<int>(std::ceil(2.5 * sigma_px + (middle_on_pixel ? 0.0 : 0.5)));
    window.pixels = 2 * window.reach + (middle_on_pixel ? 1 : 0);
    for (int power = 0; power < 3; ++power) {
      const double unit = std::pow(sigma_px, power) / 4096.0;
      double sum = 0.0;
      for (int i = 0; i < window.pixels; ++i) {
        const double x_px = i - 0.5 * (window.pixels - 1);
        const double weight =
            std::pow(x_px, power) * std::exp(-0.5 * x_px * x_px / (sigma_px * sigma_px));
        const double fixed = std::round(weight / unit);
        window.weight[static_cast<size_t>(power)][static_cast<size_t>(i)] =
            static_cast<int16_t>(fixed);
        sum += fixed * unit;
      }
      window.unit[power] = static_cast<float>(unit);
      window.sum[power] = static_cast<float>(sum);
    }
    return window;
  }

  std::vector<MomentWindow> windows_;  // middle on a pixel, then between two, for each sigma
  std::array<int, 96> nearest_{};
};

// The width of a Gaussian for each pixel of a run's length, by how many times as high as the level
// the run was cut at it is.
class RunWidths {
 public:
  RunWidths() {
    for (size_t k = 0; k < sigma_.size(); ++k) {
      const double ratio = std::max(1.3, (static_cast<double>(k) + 0.5) / kPerOne);
      sigma_[k] = static_cast<float>(0.5 / std::sqrt(2.0 * std::log(ratio)));
    }
  }
  float At(float ratio) const {
    return sigma_[static_cast<size_t>(
        std::clamp(ratio * kPerOne, 0.0F, static_cast<float>(sigma_.size() - 1)))];
  }

 private:
  static constexpr float kPerOne = 4.0F;
  std::array<float, 128> sigma_{};
};

}  // namespace

const MomentWindow& WindowFor(float sigma_px, bool middle_on_pixel) {
  static const Windows windows;
  return windows.For(sigma_px, middle_on_pixel);
}

float SigmaOfRun(int length, float ratio) {
  static const RunWidths widths;
  return static_cast<float>(length) * widths.At(ratio);
}

}  // namespace geon::rangefinder
