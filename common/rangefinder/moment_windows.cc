#include "rangefinder/moment_windows.h"

#include <algorithm>
#include <array>
#include <cmath>

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
  const MomentWindow& For(double sigma_px, bool middle_on_pixel) const {
    const auto k = static_cast<size_t>(
        std::clamp(sigma_px * kPerPixel, 0.0, static_cast<double>(nearest_.size() - 1)));
    return windows_[static_cast<size_t>(2 * nearest_[k] + (middle_on_pixel ? 0 : 1))];
  }

 private:
  static constexpr int kSigmas = 20;
  static constexpr double kPerPixel = 8.0;
  static double SigmaAt(int k) { return 0.7 * std::pow(1.15, k); }  // to 10 px

  static MomentWindow Make(double sigma_px, bool middle_on_pixel) {
    MomentWindow window;
    window.sigma_px = sigma_px;
    window.reach = static_cast<int>(std::ceil(2.5 * sigma_px + (middle_on_pixel ? 0.0 : 0.5)));
    window.pixels = 2 * window.reach + (middle_on_pixel ? 1 : 0);
    for (int power = 0; power < 3; ++power) {
      window.unit[power] = std::pow(sigma_px, power) / 4096.0;
      for (int i = 0; i < window.pixels; ++i) {
        const double x_px = i - 0.5 * (window.pixels - 1);
        const double weight =
            std::pow(x_px, power) * std::exp(-0.5 * x_px * x_px / (sigma_px * sigma_px));
        const double fixed = std::round(weight / window.unit[power]);
        window.weight[power].push_back(static_cast<int16_t>(fixed));
        window.sum[power] += fixed * window.unit[power];
      }
      while (window.weight[power].size() % kWindowPad != 0) window.weight[power].push_back(0);
    }
    return window;
  }

  std::vector<MomentWindow> windows_;  // middle on a pixel, then between two, for each sigma
  std::array<int, 96> nearest_{};
};

// What half a run's length is, in standard deviations of a Gaussian `ratio` times as high as the
// level the run was cut at.
class RunWidths {
 public:
  RunWidths() {
    for (size_t k = 0; k < half_length_.size(); ++k) {
      const double ratio = std::max(1.3, (static_cast<double>(k) + 0.5) / kPerOne);
      half_length_[k] = std::sqrt(2.0 * std::log(ratio));
    }
  }
  double At(double ratio) const {
    return half_length_[static_cast<size_t>(
        std::clamp(ratio * kPerOne, 0.0, static_cast<double>(half_length_.size() - 1)))];
  }

 private:
  static constexpr double kPerOne = 4.0;
  std::array<double, 128> half_length_{};
};

}  // namespace

const MomentWindow& WindowFor(double sigma_px, bool middle_on_pixel) {
  static const Windows windows;
  return windows.For(sigma_px, middle_on_pixel);
}

double SigmaOfRun(int length, double ratio) {
  static const RunWidths widths;
  return 0.5 * length / widths.At(ratio);
}

}  // namespace geon::rangefinder
