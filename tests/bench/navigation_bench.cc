// What a safe polygon costs, in copies of a camera's frame (README.md here).
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <random>
#include <vector>

#include "base/contracts.h"
#include "navigation/safe_polygon.h"

namespace geon {
namespace {

using Eigen::Vector2d;

template <typename Work>
double Seconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// So many obstacles all around, each with a line of its own, in no order.
std::vector<Vector2d> OnePerLine(int count) {
  constexpr double kDistance_m = 2.8;  // their lines are all inside the default box
  std::vector<Vector2d> points_R_m;
  for (int i = 0; i < count; ++i) {
    const double bearing_rad = 2.0 * std::numbers::pi * (i + 0.3) / count;
    points_R_m.emplace_back((kDistance_m + 1e-4 * (i % 7)) *
                            Vector2d(std::cos(bearing_rad), std::sin(bearing_rad)));
  }
  std::shuffle(points_R_m.begin(), points_R_m.end(), std::mt19937(1));
  return points_R_m;
}

void BM_SafePolygon(benchmark::State& state) {
  constexpr int kTimes = 100;
  const auto count = static_cast<size_t>(state.range(0));
  const std::vector<Vector2d> points_R_m = OnePerLine(static_cast<int>(count));
  std::vector<Vector2d> work_R_m = points_R_m;  // is reordered: filled anew each time
  const navigation::SafePolygonOptions options;
  Require(navigation::SafePolygon(work_R_m, options).vertices().size() == count,
          "every obstacle must give a side of the polygon");
  const std::vector<uint8_t> frame(size_t{640} * 480, 100);
  std::vector<uint8_t> copy(frame.size());
  // One after another in the same run; the least of each, which disturbance only adds to.
  double copy_s = 1.0;
  double polygon_s = 1.0;
  for (auto _ : state) {
    copy_s = std::min(copy_s, Seconds([&] {
                        std::memcpy(copy.data(), frame.data(), copy.size());
                        benchmark::DoNotOptimize(copy.data());
                        benchmark::ClobberMemory();
                      }));
    polygon_s = std::min(polygon_s,
                         Seconds([&] {
                           for (int i = 0; i < kTimes; ++i) {
                             std::copy(points_R_m.begin(), points_R_m.end(), work_R_m.begin());
                             benchmark::DoNotOptimize(navigation::SafePolygon(work_R_m, options));
                           }
                         }) / kTimes);
  }
  state.counters["polygon_us"] = 1e6 * polygon_s;
  state.counters["per_copy"] = polygon_s / copy_s;
}
BENCHMARK(BM_SafePolygon)->Arg(10)->Arg(20)->Arg(40);

}  // namespace
}  // namespace geon
