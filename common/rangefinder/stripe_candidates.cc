#include "rangefinder/stripe_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace geon::rangefinder {
namespace {

constexpr double kHalfHeight = 2.3548;  // a Gaussian's width there, in standard deviations

// Levels of a stretch of a line, noise damped for finding (not for measuring).
std::vector<double> Smooth(const LineView& image, const Run& run) {
  std::vector<double> smooth;
  smooth.reserve(static_cast<size_t>(run.length()));
  for (int i = run.first; i <= run.last; ++i) {
    const int before = image.At(run.line, std::max(i - 1, 0));
    const int after = image.At(run.line, std::min(i + 1, image.length - 1));
    smooth.push_back(0.25 * (before + 2 * image.At(run.line, i) + after));
  }
  return smooth;
}

// The unbroken stretch of `smooth` round `peak` at or above `level_1`.
Run StretchAbove(const std::vector<double>& smooth, int peak, double level_1) {
  Run stretch{0, peak, peak};
  while (stretch.first > 0 && smooth[static_cast<size_t>(stretch.first - 1)] >= level_1) {
    --stretch.first;
  }
  while (stretch.last + 1 < static_cast<int>(smooth.size()) &&
         smooth[static_cast<size_t>(stretch.last + 1)] >= level_1) {
    ++stretch.last;
  }
  return stretch;
}

// The level the stripe stands on in its neighbourhood: light scattered round a saturated stripe, or
// what the subtraction of the background left over. The median, as long as the stripe fills less
// than half.
double Pedestal(const LineView& image, int line, int middle, int reach) {
  std::vector<int> levels;
  const int last = std::min(image.length - 1, middle + reach);
  for (int i = std::max(0, middle - reach); i <= last; ++i) levels.push_back(image.At(line, i));
  const auto median = levels.begin() + static_cast<ptrdiff_t>(levels.size() / 2);
  std::nth_element(levels.begin(), median, levels.end());
  return *median;
}

class CandidateFinder {
 public:
  CandidateFinder(const LineView& image, const Background& background, double threshold_1,
                  const PeakOptions& options)
      : image_(image), background_(background), threshold_1_(threshold_1), options_(options) {}

  void Measure(std::span<const Run> runs) {
    constexpr size_t kAtOnce = 64;  // fits that stay in the nearest cache
    candidates_.reserve(runs.size());
    for (; runs.size() > kAtOnce; runs = runs.subspan(kAtOnce)) MeasureSome(runs.first(kAtOnce));
    MeasureSome(runs);
  }
  std::vector<PeakCandidate> Take() && { return std::move(candidates_); }

 private:
  void MeasureSome(std::span<const Run> runs) {
    std::vector<std::optional<ProfileFit>> fits(runs.size());
    if (options_.method == PeakMethod::kGaussian) {
      fits = FitGaussians(image_, runs, background_.level_1 + threshold_1_, background_);
    }
    for (size_t k = 0; k < runs.size(); ++k) {
      const std::optional<ProfileFit>& fit = fits[k];
      if (fit && fit->peak_1 >= threshold_1_ && runs[k].length() <= 2 * options_.max_width_px) {
        const bool too_wide = kHalfHeight * fit->width_px > options_.max_width_px;
        candidates_.push_back({runs[k].line, too_wide, *fit});
      } else {
        TakeApart(runs[k]);
      }
    }
  }

  // Brightest crest first, each blanked with what it covers.
  void TakeApart(const Run& run) {
    std::vector<double> smooth = Smooth(image_, run);
    for (int found = 0; found < options_.max_candidates; ++found) {
      const auto brightest = std::max_element(smooth.begin(), smooth.end());
      if (*brightest < background_.level_1 + threshold_1_) return;
      const Run covered = MeasureCrest(run, smooth, static_cast<int>(brightest - smooth.begin()));
      const int first = std::max(covered.first, 0);
      const int last = std::min(covered.last, run.length() - 1);
      std::fill(smooth.begin() + first, smooth.begin() + last + 1, 0.0);
    }
  }

  // Adds the crest at `peak` of a smoothed run; returns what it covers, counted from the run's
  // first pixel.
  Run MeasureCrest(const Run& run, const std::vector<double>& smooth, int peak) {
    const double peak_level_1 = smooth[static_cast<size_t>(peak)];
    const Run crest = StretchAbove(
        smooth, peak, background_.level_1 + 0.9 * (peak_level_1 - background_.level_1));
    const Background pedestal{
        std::max(background_.level_1,
                 Pedestal(image_, run.line, run.first + (crest.first + crest.last) / 2,
                          options_.max_width_px)),
        background_.noise_1};
    const double height_1 = peak_level_1 - pedestal.level_1;
    const double half_level_1 = pedestal.level_1 + 0.5 * height_1;
    Run half = StretchAbove(smooth, peak, half_level_1);
    const int reach = std::max(options_.half_window_px, half.length());
    const int center = (half.first + half.last) / 2;
    const Run covered{run.line, std::min(center - reach, half.first),
                      std::max(center + reach, half.last)};

    const Run half_run{run.line, run.first + half.first, run.first + half.last};
    const bool too_wide = half.length() > options_.max_width_px || height_1 < threshold_1_;
    std::optional<ProfileFit> fit;
    if (!too_wide && options_.method == PeakMethod::kGaussian) {
      fit = FitGaussians(image_, {&half_run, 1}, half_level_1, pedestal).front();
    }
    if (!fit) {
      fit = MeasureCentroid(image_, half_run, background_.noise_1, options_.base_fraction_1,
                            options_.half_window_px);
    }
    if (fit) candidates_.push_back({run.line, too_wide, *fit});
    return covered;
  }

  const LineView& image_;
  const Background& background_;
  double threshold_1_;
  const PeakOptions& options_;
  std::vector<PeakCandidate> candidates_;
};

// Leaves a line its brightest candidates, and none in the window of a brighter one: that is the
// same light, broken by speckle or scattered.
void KeepBrightest(const PeakOptions& options, std::vector<PeakCandidate>* candidates) {
  const auto end_of_all = candidates->end();
  auto kept = candidates->begin();
  for (auto begin = kept, end = begin; begin != end_of_all; begin = end) {
    end = std::find_if(begin, end_of_all,
                       [&](const PeakCandidate& other) { return other.line != begin->line; });
    if (end - begin > 1) {
      std::stable_sort(begin, end, [](const PeakCandidate& a, const PeakCandidate& b) {
        return a.fit.peak_1 > b.fit.peak_1;
      });
    }
    const auto first_kept = kept;
    for (auto candidate = begin; candidate != end; ++candidate) {
      if (kept - first_kept == options.max_candidates) break;
      const bool in_window = std::any_of(first_kept, kept, [&](const PeakCandidate& brighter) {
        return std::abs(brighter.fit.position_px - candidate->fit.position_px) <=
               options.half_window_px;
      });
      if (in_window) continue;
      if (kept != candidate) *kept = *candidate;
      ++kept;
    }
  }
  candidates->erase(kept, end_of_all);
}

using Histogram = std::array<int, 256>;

// Of the pixels below level `end`.
Background FromHistogram(const Histogram& histogram, int end) {
  constexpr double kRounding = 0.29;  // of a level to a whole number: the least noise there is
  end = std::clamp(end, 1, static_cast<int>(histogram.size()));
  const double samples = std::accumulate(histogram.begin(), histogram.begin() + end, 0);
  const auto quantile = [&](double share) {
    // Within a level, its pixels count as spread evenly over the level's unit of grey.
    double below = 0.0;
    const double wanted = share * samples;
    for (int level = 0; level < end; ++level) {
      const double here = histogram[static_cast<size_t>(level)];
      if (below + here >= wanted && here > 0.0) return level - 0.5 + (wanted - below) / here;
      below += here;
    }
    return 255.0;
  };
  const double median_1 = std::max(0.0, quantile(0.5));
  return {median_1, std::max(kRounding, quantile(0.8413) - median_1)};
}

}  // namespace

Background MeasureBackground(const sensor::Image& gray) {
  constexpr size_t kSamples = 4096;
  const auto width = static_cast<size_t>(gray.width_px);
  const size_t pixels = width * static_cast<size_t>(gray.height_px);
  // Odd, so that the samples do not line up in columns.
  const size_t step = pixels / std::min(kSamples, pixels) | 1U;
  std::array<std::array<int, 256>, 4> counts{};  // four, so that equal levels need not wait
  size_t u = 0;
  const uint8_t* row = gray.data.data();
  for (size_t i = 0, sample = 0; i < pixels; i += step, ++sample) {
    ++counts[sample % 4][row[u]];
    for (u += step; u >= width; u -= width) row += gray.row_stride_bytes;
  }
  Histogram histogram{};
  for (size_t level = 0; level < histogram.size(); ++level) {
    for (const auto& count : counts) histogram[level] += count[level];
  }
  // Once more without what is brighter than noise: in a small image the stripe is much of it.
  const Background background = FromHistogram(histogram, 256);
  return FromHistogram(histogram,
                       static_cast<int>(std::ceil(background.level_1 + 4.0 * background.noise_1)));
}

std::vector<PeakCandidate> FindCandidates(const sensor::Image& gray, sensor::Laser laser,
                                          const Background& background,
                                          const PeakOptions& options) {
  const double threshold_1 =
      std::max(options.min_peak_1, options.noise_factor_1 * background.noise_1);
  const double level_1 = std::ceil(background.level_1 + threshold_1);
  if (level_1 > 255.0) return {};
  const LineView image(gray, laser);
  CandidateFinder finder(image, background, threshold_1, options);
  finder.Measure(FindRuns(gray, laser, static_cast<uint8_t>(level_1)));
  std::vector<PeakCandidate> candidates = std::move(finder).Take();
  KeepBrightest(options, &candidates);
  return candidates;
}

}  // namespace geon::rangefinder
