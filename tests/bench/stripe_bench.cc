// What finding a stripe costs, in copies of the frame it is found in (README.md here).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <vector>

#include "rangefinder/stripe_peaks.h"
#include "tests/common/rangefinder/synthetic_stripe.h"

namespace geon {
namespace {

using rangefinder::PeakMethod;
using rangefinder::SyntheticStripe;
using sensor::Laser;

// Several, so that none stays in the nearest cache: a slope with steps of 40 px.
std::vector<sensor::Image> Frames(Laser laser, double amplitude_1) {
  std::vector<sensor::Image> frames;
  for (int frame = 0; frame < 8; ++frame) {
    SyntheticStripe stripe;
    stripe.laser = laser;
    stripe.amplitude_1 = amplitude_1;
    stripe.gain_1 = 0.05;
    stripe.seed = static_cast<unsigned>(frame + 1);
    stripe.position_px = [frame](int line) {
      return 200.3 + frame + 0.07 * line - (line / 80 % 2) * 40.0;
    };
    frames.push_back(stripe.Render());
  }
  return frames;
}

template <typename Work>
double Seconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Equation 3.6 down each line after another, in floating point, on what rises above a fixed level.
double NaiveCentroids(const sensor::Image& image, Laser laser) {
  const bool horizontal = laser == Laser::kHorizontal;
  const int lines = horizontal ? image.width_px : image.height_px;
  const int length = horizontal ? image.height_px : image.width_px;
  double sum = 0.0;
  for (int line = 0; line < lines; ++line) {
    double weights = 0.0;
    double moment = 0.0;
    for (int i = 0; i < length; ++i) {
      const int index =
          horizontal ? i * image.row_stride_bytes + line : line * image.row_stride_bytes + i;
      const double weight = std::max(0.0, image.data[static_cast<size_t>(index)] - 25.0);
      weights += weight;
      moment += weight * i;
    }
    sum += weights > 0.0 ? moment / weights : 0.0;
  }
  return sum;
}

void BM_Stripe(benchmark::State& state, Laser laser, PeakMethod method, double amplitude_1) {
  const std::vector<sensor::Image> frames = Frames(laser, amplitude_1);
  rangefinder::PeakOptions options;
  options.method = method;
  std::vector<uint8_t> copy(frames[0].data.size());
  // One after another in the same run; the least of each, which disturbance only adds to.
  double copy_s = 1.0;
  double find_s = 1.0;
  double naive_s = 1.0;
  for (auto _ : state) {
    copy_s = std::min(copy_s, Seconds([&] {
                        for (const sensor::Image& frame : frames) {
                          std::memcpy(copy.data(), frame.data.data(), copy.size());
                          benchmark::DoNotOptimize(copy.data());
                          benchmark::ClobberMemory();
                        }
                      }));
    find_s =
        std::min(find_s, Seconds([&] {
                   for (const sensor::Image& frame : frames) {
                     benchmark::DoNotOptimize(rangefinder::FindStripePeaks(frame, laser, options));
                   }
                 }));
    naive_s = std::min(naive_s, Seconds([&] {
                         for (const sensor::Image& frame : frames) {
                           benchmark::DoNotOptimize(NaiveCentroids(frame, laser));
                         }
                       }));
  }
  state.counters["per_copy"] = find_s / copy_s;
  state.counters["naive_per_copy"] = naive_s / copy_s;
}

BENCHMARK_CAPTURE(BM_Stripe, gaussian_horizontal, Laser::kHorizontal, PeakMethod::kGaussian, 180.0);
BENCHMARK_CAPTURE(BM_Stripe, gaussian_vertical, Laser::kVertical, PeakMethod::kGaussian, 180.0);
BENCHMARK_CAPTURE(BM_Stripe, gaussian_clipped, Laser::kHorizontal, PeakMethod::kGaussian, 720.0);
BENCHMARK_CAPTURE(BM_Stripe, centroid_horizontal, Laser::kHorizontal, PeakMethod::kCentroid, 180.0);

}  // namespace
}  // namespace geon
