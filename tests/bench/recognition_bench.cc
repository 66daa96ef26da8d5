// What RecognizeGeon costs: by method and kind of scan, and how the cost grows with points and
// views. README.md says how to read it.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstring>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <string>

#include "base/angles.h"
#include "evaluation/object_tracer.h"
#include "evaluation/random_scan.h"
#include "evaluation/scan_maker.h"
#include "evaluation/thesis_objects.h"
#include "evaluation/trial_random.h"
#include "recognition/recognize_geon.h"

namespace geon {
namespace {

using recognition::Method;

// How a scan is made. `fineness` times as many pixels over the same field of view.
struct Kind {
  const char* name;
  GeonLabel label;
  bool floor;
  double range_m;
};
constexpr Kind kKinds[] = {{"cuboid in the air", GeonLabel::kCuboid, false, 1.0},
                           {"bent cylinder in the air", GeonLabel::kBentCylinder, false, 1.3},
                           {"ellipsoid in the air, far", GeonLabel::kEllipsoid, false, 1.6},
                           {"cuboid on a floor", GeonLabel::kCuboid, true, 1.0},
                           {"tapered cylinder on a floor", GeonLabel::kTaperedCylinder, true, 1.3}};

sensor::ScanSet MakeView(const Kind& kind, int fineness, int view_index) {
  geons::GeonShape shape;
  for (const evaluation::ExperimentObject& object : evaluation::ThesisObjects()) {
    if (object.shape.label == kind.label) shape = object.shape;  // the slightest of the four
  }
  const evaluation::ObjectTracer object(
      evaluation::ShapeMesh(shape, evaluation::Family::kSuperquadric));
  evaluation::ViewOptions view;
  view.range_m = kind.range_m;
  view.elevation_rad = RadiansFromDegrees(40.0);
  view.azimuth_rad = RadiansFromDegrees(30.0 + 40.0 * view_index);
  view.floor = kind.floor;
  evaluation::RangefinderOptions rangefinder;
  rangefinder.width_px *= fineness;
  rangefinder.height_px *= fineness;
  rangefinder.focal_px *= fineness;
  std::mt19937_64 random = evaluation::TrialRandom(1, static_cast<uint64_t>(view_index));
  return evaluation::MakeScan(object, view, {}, rangefinder, random);
}

int64_t Points(const std::vector<sensor::ScanSet>& scans) {
  size_t points = 0;
  for (const sensor::ScanSet& scan : scans) {
    for (const sensor::RangeProfile& profile : scan.profiles) points += profile.p_L_m.size();
  }
  return static_cast<int64_t>(points);
}

double Now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <typename Work>
double BestOf(int tries, const Work& work) {
  double best_s = std::numeric_limits<double>::infinity();
  for (int k = 0; k < tries; ++k) {
    const double start_s = Now_s();
    work();
    best_s = std::min(best_s, Now_s() - start_s);
  }
  return best_s;
}

// The yardsticks: a camera frame copied, and blurred by OpenCV. Measured beside each benchmark, so
// that a slow or busy machine slows both.
struct Peers {
  double copy_s = 0.0;
  double blur_s = 0.0;
};
Peers MeasurePeers() {
  cv::setNumThreads(1);
  cv::Mat frame(480, 640, CV_8U), copy(480, 640, CV_8U);
  cv::randu(frame, 0, 255);
  const auto memcpy_frame = [&] {
    std::memcpy(copy.data, frame.data, frame.total());
    benchmark::DoNotOptimize(copy.data);
    benchmark::ClobberMemory();
  };
  const auto blur_frame = [&] { cv::GaussianBlur(frame, copy, {5, 5}, 1.0); };
  return {BestOf(200, memcpy_frame), BestOf(50, blur_frame)};
}

void Recognize(benchmark::State& state, const std::vector<sensor::ScanSet>& scans, Method method) {
  recognition::RecognitionOptions options;
  options.method = method;
  const auto recognize_all = [&] {
    for (const sensor::ScanSet& scan : scans) {
      benchmark::DoNotOptimize(recognition::RecognizeGeon(scan, options));
    }
  };
  for (auto _ : state) recognize_all();
  int64_t on_target = 0;
  for (const sensor::ScanSet& scan : scans) {
    for (const auto& profile : recognition::RecognizeGeon(scan, options).profiles) {
      on_target += profile.points;
    }
  }
  const double own_s = BestOf(50, recognize_all) / static_cast<double>(scans.size());
  const Peers peers = MeasurePeers();
  state.SetComplexityN(Points(scans));
  state.counters["points"] = static_cast<double>(Points(scans));
  state.counters["on_target"] = static_cast<double>(on_target);
  state.counters["per_copy"] = own_s / peers.copy_s;
  state.counters["per_blur"] = own_s / peers.blur_s;
}

void BM_Kind(benchmark::State& state, Method method) {
  const Kind& kind = kKinds[state.range(0)];
  state.SetLabel(kind.name);
  Recognize(state, {MakeView(kind, 1, 0)}, method);
}

// The argument: pixels per pixel of the real camera.
void BM_Points(benchmark::State& state, Method method) {
  Recognize(state, {MakeView(kKinds[0], static_cast<int>(state.range(0)), 0)}, method);
}

// The argument: how many scan sets, each from another side.
void BM_Views(benchmark::State& state, Method method) {
  std::vector<sensor::ScanSet> scans;
  for (int k = 0; k < state.range(0); ++k) scans.push_back(MakeView(kKinds[0], 1, k));
  Recognize(state, scans, method);
}

#define GEON_BENCHMARK(function, method) \
  BENCHMARK_CAPTURE(function, method, Method::k##method)->Unit(benchmark::kMicrosecond)
GEON_BENCHMARK(BM_Kind, Thesis)->DenseRange(0, std::size(kKinds) - 1);
GEON_BENCHMARK(BM_Kind, Evidence)->DenseRange(0, std::size(kKinds) - 1);
GEON_BENCHMARK(BM_Points, Thesis)->RangeMultiplier(2)->Range(1, 8)->Complexity(benchmark::oN);
GEON_BENCHMARK(BM_Points, Evidence)->RangeMultiplier(2)->Range(1, 8)->Complexity(benchmark::oN);
GEON_BENCHMARK(BM_Views, Thesis)->RangeMultiplier(2)->Range(1, 8)->Complexity(benchmark::oN);
GEON_BENCHMARK(BM_Views, Evidence)->RangeMultiplier(2)->Range(1, 8)->Complexity(benchmark::oN);

}  // namespace
}  // namespace geon
