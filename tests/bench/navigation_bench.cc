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
std::vector<Vector2d> OnePerLine(int count, std::mt19937* random) {
  constexpr double kDistance_m = 2.8;  // their lines are all inside the default box
  std::uniform_real_distribution<double> uneven_m(0.0, 1e-3);
  const double first_rad = 1e3 * uneven_m(*random);
  std::vector<Vector2d> points_R_m;
  for (int i = 0; i < count; ++i) {
    const double bearing_rad = first_rad + 2.0 * std::numbers::pi * i / count;
    points_R_m.emplace_back((kDistance_m + uneven_m(*random)) *
                            Vector2d(std::cos(bearing_rad), std::sin(bearing_rad)));
  }
  std::shuffle(points_R_m.begin(), points_R_m.end(), *random);
  return points_R_m;
}

void BM_SafePolygon(benchmark::State& state) {
  constexpr int kSets = 256;  // so many that the processor cannot learn them by heart
  const auto count = static_cast<size_t>(state.range(0));
  const navigation::SafePolygonOptions options;
  std::mt19937 random(1);
  std::vector<std::vector<Vector2d>> sets_R_m;
  for (int k = 0; k < kSets; ++k) {
    sets_R_m.push_back(OnePerLine(static_cast<int>(count), &random));
    std::vector<Vector2d> copy_R_m = sets_R_m.back();
    Require(navigation::SafePolygon(copy_R_m, options).vertices().size() == count,
            "every obstacle must give a side of the polygon");
  }
  std::vector<Vector2d> work_R_m(count);  // is reordered: filled anew each time
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
                           for (const std::vector<Vector2d>& set_R_m : sets_R_m) {
                             std::copy(set_R_m.begin(), set_R_m.end(), work_R_m.begin());
                             benchmark::DoNotOptimize(navigation::SafePolygon(work_R_m, options));
                           }
                         }) / kSets);
  }
  state.counters["polygon_us"] = 1e6 * polygon_s;
  state.counters["per_copy"] = polygon_s / copy_s;
}
BENCHMARK(BM_SafePolygon)->Arg(10)->Arg(20)->Arg(40);

}  // namespace
}  // namespace geon
