// What TargetFinder costs: against the copy of a frame, against recipes of OpenCV, by instruction
// set, by model, and on pictures made to be hard. README.md says how to read it.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "attention/find_target.h"
#include "attention/resolve_color.h"

namespace geon {
namespace {

using attention::AttentionOptions;
using attention::ColorModel;
using attention::SimdLevel;

constexpr int kWidth = 640;
constexpr int kHeight = 480;
constexpr int kFrames = 8;  // more than the nearest caches hold

using Paint = std::function<cv::Vec3b(int u, int v, std::mt19937& random)>;  // blue, green, red

sensor::Image Painted(unsigned seed, const Paint& paint) {
  std::mt19937 random(seed);
  sensor::Image image;
  image.width_px = kWidth;
  image.height_px = kHeight;
  image.row_stride_bytes = 3 * kWidth;
  image.format = sensor::PixelFormat::kBgr8;
  image.data.reserve(static_cast<size_t>(3 * kWidth * kHeight));
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const cv::Vec3b pixel = paint(u, v, random);
      image.data.insert(image.data.end(), {pixel[0], pixel[1], pixel[2]});
    }
  }
  return image;
}

const cv::Vec3b kRed{34, 28, 130};
const cv::Vec3b kGrey{110, 120, 125};

// A room: gradient, a shaded red disc of 30,000 pixels, a smaller one, 1,500 red specks, noise.
cv::Vec3b Room(int u, int v, std::mt19937& random) {
  cv::Vec3d color{100.0 + u / 16.0, 115.0 + v / 10.0, 120.0 + u / 11.0};
  const auto disc = [&](int u_px, int v_px, int radius_px) {
    const double x = double(u - u_px) / radius_px;
    const double y = double(v - v_px) / radius_px;
    if (x * x + y * y < 1.0) color = cv::Vec3d(kRed) * (0.85 + 0.25 * x);
  };
  disc(350, 270, 98);
  disc(120, 130, 40);
  if (random() % (kWidth * kHeight) < 1500) color = cv::Vec3d(kRed);
  std::normal_distribution<double> noise(0.0, 4.0);
  cv::Vec3b pixel;
  for (int i = 0; i < 3; ++i) pixel[i] = cv::saturate_cast<uint8_t>(color[i] + noise(random));
  return pixel;
}

struct Scene {
  const char* name;
  Paint paint;
};
const std::vector<Scene>& Scenes() {
  static const cv::Vec3b kBlack{0, 0, 0};
  static const std::vector<Scene> kScenes = {
      {"room", Room},
      {"all target", [](int, int, std::mt19937&) { return kRed; }},
      {"all cannot tell", [](int, int, std::mt19937&) { return kBlack; }},
      {"half of the pixels target",
       [](int, int, std::mt19937& random) { return random() % 2 == 0 ? kRed : kGrey; }},
      {"thirds target, other, cannot tell",
       [](int, int, std::mt19937& random) {
         return std::array{kRed, kGrey, kBlack}[random() % 3];
       }},
      {"checkerboard", [](int u, int v, std::mt19937&) { return (u + v) % 2 == 0 ? kRed : kGrey; }},
      {"checkerboard with cannot tell",
       [](int u, int v, std::mt19937&) { return (u + v) % 2 == 0 ? kRed : kBlack; }},
      {"stripes of one pixel", [](int u, int, std::mt19937&) { return u % 2 == 0 ? kRed : kGrey; }},
      {"stripes with cannot tell",
       [](int u, int, std::mt19937&) { return u % 2 == 0 ? kGrey : kBlack; }},
      {"19,200 blobs",
       [](int u, int v, std::mt19937&) { return u % 4 == 0 || v % 4 == 0 ? kGrey : kRed; }},
      {"random bytes",
       [](int, int, std::mt19937& random) {
         const auto bits = random();
         return cv::Vec3b(uint8_t(bits), uint8_t(bits >> 8), uint8_t(bits >> 16));
       }},
  };
  return kScenes;
}

std::vector<sensor::Image> FramesOf(const Scene& scene) {
  std::vector<sensor::Image> frames;
  for (unsigned seed = 1; seed <= kFrames; ++seed) frames.push_back(Painted(seed, scene.paint));
  return frames;
}

// A cone of chromaticity with a rim and levels, as `geon teach` learns them.
ColorModel Cone() {
  const auto cone = [](double width_1, double brightness_1) {
    attention::HalfSpaceColor region{{attention::WholeNumbered({1, 1, 1, brightness_1})}};
    for (int side = 0; side < 12; ++side) {
      const double angle_rad = CV_PI / 6.0 * side;
      const double a = std::cos(angle_rad);
      const double b = std::sin(angle_rad);
      // a (r - 0.67 s) + b (g - 0.15 s) < width s, with s = r + g + b.
      const double reach_1 = width_1 + 0.67 * a + 0.15 * b;
      region.half_spaces.push_back(
          attention::WholeNumbered({reach_1 - a, reach_1 - b, reach_1, 0.0}));
    }
    return region;
  };
  return {"cone", {cone(0.09, 60.0)}, {cone(0.15, 40.0)}, 30, 250};
}

ColorModel ModelNamed(const std::string& name) {
  return name == "cone" ? Cone() : *attention::NamedColorModel(name);
}

double Now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// What `work` and a copy of the frame take: of every frame the best of interleaved rounds, for
// those in which the machine did something else as well do not count.
struct Cost {
  double work_s = 0.0;
  double copy_s = 0.0;
};
Cost Measure(const std::vector<sensor::Image>& frames,
             const std::function<void(const sensor::Image&)>& work) {
  constexpr int kRounds = 60;
  std::vector<uint8_t> to(frames[0].data.size());
  const auto copy = [&to](const sensor::Image& frame) {
    std::memcpy(to.data(), frame.data.data(), to.size());
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  };
  std::vector<Cost> best(frames.size(), {1e9, 1e9});
  const auto run_all = [&](const auto& what, double Cost::*best_s) {
    for (size_t i = 0; i < frames.size(); ++i) {
      const double start_s = Now_s();
      what(frames[i]);
      best[i].*best_s = std::min(best[i].*best_s, Now_s() - start_s);
    }
  };
  for (int k = 0; k < kRounds; ++k) {
    run_all(copy, &Cost::copy_s);
    run_all(work, &Cost::work_s);
  }
  Cost sum;
  for (const Cost& cost : best) {
    sum.work_s += cost.work_s;
    sum.copy_s += cost.copy_s;
  }
  return sum;
}

void Report(benchmark::State& state, const Scene& scene,
            const std::function<void(const sensor::Image&)>& work) {
  state.SetLabel(scene.name);
  const std::vector<sensor::Image> frames = FramesOf(scene);
  size_t next = 0;
  for (auto _ : state) work(frames[next++ % frames.size()]);
  const Cost cost = Measure(frames, work);
  state.counters["per_copy"] = cost.work_s / cost.copy_s;
  state.counters["5ms_per_copy"] = 5e-3 * kFrames / cost.copy_s;
}

bool Has(SimdLevel level) {
  return std::count(attention::SimdLevels().begin(), attention::SimdLevels().end(), level) > 0;
}

// All of TargetFinder::Find, by scene.
void BM_Find(benchmark::State& state, const std::string& model, SimdLevel level) {
  if (!Has(level)) return state.SkipWithError("this processor has no such instructions");
  const attention::TargetFinder finder(ModelNamed(model), {}, level);
  Report(state, Scenes()[static_cast<size_t>(state.range(0))],
         [&](const sensor::Image& frame) { benchmark::DoNotOptimize(finder.Find(frame)); });
}

// Its stages: classes alone; and all but the byte mask.
void BM_Classify(benchmark::State& state, const std::string& model, SimdLevel level) {
  if (!Has(level)) return state.SkipWithError("this processor has no such instructions");
  const attention::PixelClassifier classifier(ModelNamed(model), level);
  Report(state, Scenes()[static_cast<size_t>(state.range(0))], [&](const sensor::Image& frame) {
    benchmark::DoNotOptimize(classifier.Classify(frame, 250));
  });
}
void BM_FindWithoutMask(benchmark::State& state, const std::string& model, SimdLevel level) {
  if (!Has(level)) return state.SkipWithError("this processor has no such instructions");
  const attention::PixelClassifier classifier(ModelNamed(model), level);
  Report(state, Scenes()[static_cast<size_t>(state.range(0))], [&](const sensor::Image& frame) {
    benchmark::DoNotOptimize(attention::MeasureBlobs(attention::GroupPixels(
        attention::Erode(attention::ResolveColor(classifier.Classify(frame, 250)), 8))));
  });
}

cv::Mat ViewOf(const sensor::Image& frame) {
  return {kHeight, kWidth, CV_8UC3, const_cast<uint8_t*>(frame.data.data())};
}
double LargestArea(const cv::Mat& mask) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
  double area = 0.0;
  for (const auto& contour : contours) area = std::max(area, cv::contourArea(contour));
  return area;
}

// Peers: what one would write with OpenCV. A box of BGR (not the thesis's region), and hue.
void BM_OpenCvBgrBox(benchmark::State& state) {
  cv::setNumThreads(1);
  cv::Mat mask;
  Report(state, Scenes()[static_cast<size_t>(state.range(0))], [&](const sensor::Image& frame) {
    cv::inRange(ViewOf(frame), cv::Scalar(0, 0, 80), cv::Scalar(75, 75, 255), mask);
    cv::erode(mask, mask, cv::Mat());
    benchmark::DoNotOptimize(LargestArea(mask));
  });
}
void BM_OpenCvHue(benchmark::State& state) {
  cv::setNumThreads(1);
  cv::Mat hsv;
  cv::Mat low;
  cv::Mat high;
  Report(state, Scenes()[static_cast<size_t>(state.range(0))], [&](const sensor::Image& frame) {
    cv::cvtColor(ViewOf(frame), hsv, cv::COLOR_BGR2HSV);
    cv::inRange(hsv, cv::Scalar(0, 120, 60), cv::Scalar(10, 255, 255), low);
    cv::inRange(hsv, cv::Scalar(170, 120, 60), cv::Scalar(180, 255, 255), high);
    cv::bitwise_or(low, high, low);
    cv::erode(low, low, cv::Mat());
    benchmark::DoNotOptimize(LargestArea(low));
  });
}

void Register() {
  const std::pair<const char*, SimdLevel> levels[] = {{"baseline", SimdLevel::kBaseline},
                                                      {"avx2", SimdLevel::kAvx2},
                                                      {"avx512", SimdLevel::kAvx512}};
  const std::pair<const char*, void (*)(benchmark::State&, const std::string&, SimdLevel)>
      stages[] = {{"BM_Classify", BM_Classify},
                  {"BM_FindWithoutMask", BM_FindWithoutMask},
                  {"BM_Find", BM_Find}};
  const auto add = [](const std::string& name, const auto& run) {
    return benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMicrosecond);
  };
  add("BM_OpenCvBgrBox", BM_OpenCvBgrBox)->Arg(0);
  add("BM_OpenCvHue", BM_OpenCvHue)->Arg(0);
  for (const std::string model : {"super-red", "thesis-lab", "thesis-lab-sun", "cone"}) {
    for (const auto& [level_name, level] : levels) {
      for (const auto& [stage_name, stage] : stages) {
        add(stage_name + ("/" + model + "/") + level_name, [=, level = level, stage = stage](
                                                               benchmark::State& state) {
          stage(state, model, level);
        })->Arg(0);
      }
    }
  }
  const SimdLevel best = attention::SimdLevels().back();
  for (size_t scene = 1; scene < Scenes().size(); ++scene) {
    for (const std::string model : {"super-red", "cone"}) {
      add("BM_Hard/" + model, [=](benchmark::State& state) {
        BM_Find(state, model, best);
      })->Arg(static_cast<int64_t>(scene));
    }
  }
}

}  // namespace
}  // namespace geon

int main(int argc, char** argv) {
  geon::Register();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
