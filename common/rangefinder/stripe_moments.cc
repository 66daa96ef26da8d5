#include "rangefinder/stripe_moments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core/hal/intrin.hpp>

#include "rangefinder/moment_windows.h"

namespace geon::rangefinder {
namespace {

constexpr size_t kBatch = 64;
// A run on its way to a profile, and the window it is seen through next.
struct View {
  size_t run = 0;
  int twice_middle = 0;  // in half pixels
  float sigma_px = 0.0F;
  const MomentWindow* window = nullptr;
};
View ViewOf(size_t run, int twice_middle, float sigma_px) {
  return {run, twice_middle, sigma_px, &WindowFor(sigma_px, twice_middle % 2 == 0)};
}

// Profiles side by side: what is seen of each, and what follows from it.
struct Batch {
  using Lanes = std::array<float, kBatch>;
  std::array<int, kBatch> brightest;
  // Sums of (level - floor) times 1, x and x^2 under a window of sigma_px.
  Lanes sum, sum_x, sum_xx, sigma_px;
  Lanes part;  // variance of profile times window, of the window's: between 0 and 1
  Lanes shift_px, width_px, peak_1, per_noise, per_gain;
};

// All in closed form: the product of the profile (sigma w) and the window (sigma s) is a Gaussian
// of variance u^2 = w^2 s^2 / (w^2 + s^2), shifted by s^2 / (s^2 + w^2) of the way. Where the light
// is no such profile, numbers without meaning.
void Solve(size_t count, Batch* batch) {
  constexpr float kSqrtPi = 1.7724539F;
  constexpr float kSqrtTwoPi = 2.5066283F;
  Batch& b = *batch;
  for (size_t k = 0; k < count; ++k) {
    const float s2 = b.sigma_px[k] * b.sigma_px[k];
    const float per_sum = 1.0F / b.sum[k];
    const float mean_px = b.sum_x[k] * per_sum;
    const float u2 = b.sum_xx[k] * per_sum - mean_px * mean_px;
    const float stretch = s2 / (s2 - u2);  // 1 + w^2 / s^2
    const float w2 = u2 * stretch;
    b.part[k] = u2 / s2;
    b.shift_px[k] = mean_px * stretch;
    b.width_px[k] = std::sqrt(w2);
    // exp(x), which is near 1
    const float x = 0.5F * b.shift_px[k] * mean_px / s2;
    const float rise = 1.0F + x * (1.0F + x / 2.0F * (1.0F + x / 3.0F * (1.0F + x / 4.0F)));
    b.peak_1[k] = b.sum[k] / (kSqrtTwoPi * std::sqrt(u2)) * rise;
    // The sum of window^2 x^2 v, where v is the same for every pixel, or follows the profile.
    const float gain = stretch * per_sum;
    const float shared2 = w2 * s2 / (2.0F * w2 + s2);
    b.per_noise[k] = gain * gain * 0.5F * kSqrtPi * s2 * b.sigma_px[k];
    b.per_gain[k] = gain * gain * b.peak_1[k] * kSqrtTwoPi * shared2 * std::sqrt(shared2);
  }
}

// `count` pixels of a line, eight at most, and zeros.
cv::v_int16x8 Eight(const uint8_t* pixel, ptrdiff_t step, int count) {
  if (step == 1 && count >= 8) return cv::v_reinterpret_as_s16(cv::v_load_expand(pixel));
  uint64_t levels = 0;  // one store, so that the load need not wait for eight
  if (count >= 8) {
    for (int i = 0; i < 8; ++i) levels |= uint64_t{pixel[i * step]} << (8 * i);
  } else {
    for (int i = 0; i < count; ++i) levels |= uint64_t{pixel[i * step]} << (8 * i);
  }
  return cv::v_reinterpret_as_s16(cv::v_load_expand(reinterpret_cast<const uint8_t*>(&levels)));
}

enum class Outcome { kMeasured, kNoProfile, kClipped, kLookAgain };

class MomentFitter {
 public:
  MomentFitter(const LineView& image, std::span<const Run> runs, double level_1,
               const Background& background)
      : image_(image),
        runs_(runs),
        background_(background),
        per_ratio_1_(1.0 / (level_1 - background.level_1)),
        top_of_floor_(static_cast<int>(102.0 * background.level_1) + 1023) {}

  // A window for a first look: of a width that suits the run's length and its middle's height.
  View FirstView(size_t k) const {
    const Run& run = runs_[k];
    const int middle = (run.first + run.last) / 2;
    const double ratio = (image_.At(run.line, middle) - background_.level_1) * per_ratio_1_;
    return ViewOf(k, run.first + run.last, SigmaOfRun(run.length(), static_cast<float>(ratio)));
  }

  // Sees profile k of the batch through its window.
  Outcome Look(const View& view, bool first_look, size_t k, Batch* batch, ProfileFit* fit) const {
    const MomentWindow& window = *view.window;
    const int line = runs_[view.run].line;
    fit->first = (view.twice_middle + 1) / 2 - window.reach;
    fit->last = fit->first + window.pixels - 1;
    if (fit->first < 0 || fit->last >= image_.length) {
      return first_look && IsClippedAtEdge(view) ? Outcome::kClipped : Outcome::kNoProfile;
    }
    fit->floor_1 = FloorBeside(image_, line, fit->first, fit->last, background_.noise_1);

    const ptrdiff_t step = image_.pixel_step;
    const uint8_t* pixel = image_.Line(line) + fit->first * step;
    cv::v_int32x4 sums[3] = {cv::v_setzero_s32(), cv::v_setzero_s32(), cv::v_setzero_s32()};
    std::array<cv::v_int16x8, kMostWindowPixels / 8> levels;
    cv::v_int16x8 most = cv::v_setzero_s16();
    for (int i = 0; i < window.pixels; i += 8) {
      const cv::v_int16x8 weight = cv::v_load(window.weight[0].data() + i);
      const cv::v_int16x8 level = Eight(pixel + i * step, step, image_.length - fit->first - i) &
                                  (weight > cv::v_setzero_s16());
      levels[static_cast<size_t>(i / 8)] = level;
      most = cv::v_max(most, level);
      sums[0] = cv::v_dotprod(level, weight, sums[0]);
      for (size_t power = 1; power < 3; ++power) {
        sums[power] =
            cv::v_dotprod(level, cv::v_load(window.weight[power].data() + i), sums[power]);
      }
    }
    const auto moment = [&](size_t power) {
      return window.unit[power] * static_cast<float>(cv::v_reduce_sum(sums[power])) -
             static_cast<float>(fit->floor_1) * window.sum[power];
    };
    batch->sum[k] = moment(0);
    batch->sum_x[k] = moment(1);
    batch->sum_xx[k] = moment(2);
    batch->sigma_px[k] = window.sigma_px;
    batch->brightest[k] = cv::v_reduce_max(most);
    if (!first_look) return Outcome::kMeasured;
    const cv::v_int16x8 top = cv::v_setall_s16(TopOf(batch->brightest[k]));
    cv::v_int16x8 bright = cv::v_setzero_s16();
    for (int i = 0; i < window.pixels; i += 8) {
      bright -= levels[static_cast<size_t>(i / 8)] >= top;
    }
    return IsClipped(batch->brightest[k], cv::v_reduce_sum(bright), view.sigma_px)
               ? Outcome::kClipped
               : Outcome::kMeasured;
  }

  // What is made of profile k of the batch; prepares the view for another look.
  Outcome Judge(const Batch& batch, size_t k, bool last_round, View* view, ProfileFit* fit) const {
    constexpr float kShift = 0.5F;     // of the window's sigma: further off it is moved
    constexpr float kMismatch = 1.3F;  // between its sigma and the profile's
    // A Gaussian's height follows from its area; of a run of another shape it does not.
    constexpr double kLeastHeight = 0.65;
    constexpr double kMostHeight = 1.5;
    if (!(batch.sum[k] > 0.0F && batch.part[k] > 0.05F && batch.part[k] < 0.95F)) {
      return Outcome::kNoProfile;
    }
    fit->position_px = 0.5 * view->twice_middle + batch.shift_px[k];
    fit->width_px = batch.width_px[k];
    fit->peak_1 = batch.peak_1[k];
    fit->per_noise = batch.per_noise[k];
    fit->per_gain = batch.per_gain[k];
    const float shift_px = std::abs(batch.shift_px[k]);
    const float sigma_px = batch.sigma_px[k];
    const bool suits = shift_px <= kShift * sigma_px && batch.width_px[k] < kMismatch * sigma_px &&
                       kMismatch * batch.width_px[k] > sigma_px;
    if (!suits && !last_round) {
      if (shift_px > 0.5F * static_cast<float>(runs_[view->run].length()) + 1.0F) {
        return Outcome::kNoProfile;  // left its run
      }
      *view = ViewOf(view->run, static_cast<int>(std::lround(2.0 * fit->position_px)),
                     batch.width_px[k]);
      return Outcome::kLookAgain;
    }
    const double height_1 = batch.brightest[k] - fit->floor_1;
    const bool fits =
        fit->peak_1 >= kLeastHeight * height_1 && fit->peak_1 <= kMostHeight * height_1;
    return fits ? Outcome::kMeasured : Outcome::kNoProfile;
  }

 private:
  // Pixels from this level on are as bright as the crest: 0.9 of its height.
  int16_t TopOf(int brightest) const {
    return static_cast<int16_t>((922 * brightest + top_of_floor_) >> 10);
  }
  // Whether the crest may hide how bright it was: saturated, or more of it as bright as the
  // brightest than of a Gaussian (a difference of two frames clips wherever the unlit one left no
  // room).
  static bool IsClipped(int brightest, int bright_pixels, float sigma_px) {
    constexpr float kTopOfGaussian = 0.918F;  // pixels for a sigma of one
    return brightest >= kSaturated ||
           static_cast<float>(bright_pixels) > 2.0F * kTopOfGaussian * sigma_px + 1.0F;
  }

  // The same of a run whose window leaves the image.
  bool IsClippedAtEdge(const View& view) const {
    const Run& run = runs_[view.run];
    int brightest = 0;
    for (int i = run.first; i <= run.last; ++i) {
      brightest = std::max(brightest, image_.At(run.line, i));
    }
    const int top = TopOf(brightest);
    int bright = 0;
    for (int i = run.first; i <= run.last; ++i) bright += image_.At(run.line, i) >= top ? 1 : 0;
    return IsClipped(brightest, bright, view.sigma_px);
  }

  const LineView& image_;
  std::span<const Run> runs_;
  const Background& background_;
  double per_ratio_1_;
  int top_of_floor_;
};

}  // namespace

std::vector<size_t> FitByMoments(const LineView& image, std::span<const Run> runs, double level_1,
                                 const Background& background,
                                 std::span<std::optional<ProfileFit>> fits) {
  constexpr int kRounds = 4;
  const MomentFitter fitter(image, runs, level_1, background);
  std::vector<View> views(runs.size());
  for (size_t k = 0; k < runs.size(); ++k) views[k] = fitter.FirstView(k);
  std::vector<size_t> clipped;
  Batch batch{};
  for (int round = 0; round < kRounds && !views.empty(); ++round) {
    size_t left = 0;
    for (size_t begin = 0; begin < views.size(); begin += kBatch) {
      const size_t count = std::min(kBatch, views.size() - begin);
      const auto part = std::span(views).subspan(begin, count);
      std::array<Outcome, kBatch> outcome;
      for (size_t k = 0; k < count; ++k) {
        outcome[k] = fitter.Look(part[k], round == 0, k, &batch, &fits[part[k].run].emplace());
      }
      Solve(count, &batch);
      for (size_t k = 0; k < count; ++k) {
        const size_t run = part[k].run;
        if (outcome[k] == Outcome::kMeasured) {
          outcome[k] = fitter.Judge(batch, k, round + 1 == kRounds, &part[k], &*fits[run]);
        }
        if (outcome[k] == Outcome::kLookAgain) views[left++] = part[k];
        if (outcome[k] == Outcome::kMeasured || outcome[k] == Outcome::kLookAgain) continue;
        fits[run].reset();
        if (outcome[k] == Outcome::kClipped) clipped.push_back(run);
      }
    }
    views.resize(left);
  }
  return clipped;
}

}  // namespace geon::rangefinder
