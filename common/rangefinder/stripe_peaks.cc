#include "rangefinder/stripe_peaks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/contracts.h"
#include "rangefinder/stripe_pieces.h"

namespace geon::rangefinder {
namespace {

// The image as lines across the stripe: columns of a horizontal one, rows of a vertical one.
struct Lines {
  int count = 0;
  int length = 0;
  std::vector<uint8_t> level;
  std::span<const uint8_t> Line(int line) const {
    return {level.data() + static_cast<size_t>(line) * static_cast<size_t>(length),
            static_cast<size_t>(length)};
  }
};

Lines AcrossStripe(const sensor::Image& image, sensor::Laser laser) {
  const bool horizontal = laser == sensor::Laser::kHorizontal;
  const auto width = static_cast<size_t>(image.width_px);
  const auto height = static_cast<size_t>(image.height_px);
  const auto stride = static_cast<size_t>(image.row_stride_bytes);
  Lines lines;
  lines.count = horizontal ? image.width_px : image.height_px;
  lines.length = horizontal ? image.height_px : image.width_px;
  lines.level.resize(width * height);
  for (size_t v = 0; v < height; ++v) {
    const uint8_t* row = image.data.data() + v * stride;
    if (!horizontal) {
      std::copy(row, row + width, lines.level.begin() + static_cast<ptrdiff_t>(v * width));
      continue;
    }
    for (size_t u = 0; u < width; ++u) lines.level[u * height + v] = row[u];
  }
  return lines;
}

struct Background {
  double level_1 = 0.0;
  double noise_1 = 0.0;  // standard deviation
};

// Median and the 84 % point, which the stripe's few pixels do not move; right also where the
// subtraction of the unlit frame cut the noise off at 0.
Background MeasureBackground(const Lines& lines) {
  std::vector<size_t> histogram(256, 0);
  for (const uint8_t level : lines.level) ++histogram[level];
  const auto quantile = [&](double share) {
    // Within a level, its pixels count as spread evenly over the level's unit of grey.
    double below = 0.0;
    const double wanted = share * static_cast<double>(lines.level.size());
    for (size_t level = 0; level < 256; ++level) {
      const auto here = static_cast<double>(histogram[level]);
      if (below + here >= wanted && here > 0.0) {
        return static_cast<double>(level) - 0.5 + (wanted - below) / here;
      }
      below += here;
    }
    return 255.0;
  };
  const double median_1 = std::max(0.0, quantile(0.5));
  return {median_1, std::max(0.0, quantile(0.8413) - median_1)};
}

// Levels above the background, noise damped for finding (not for measuring).
std::vector<double> Smooth(std::span<const uint8_t> line, double background_1) {
  std::vector<double> smooth(line.size());
  for (size_t i = 0; i < line.size(); ++i) {
    const double before = line[i > 0 ? i - 1 : i];
    const double after = line[i + 1 < line.size() ? i + 1 : i];
    smooth[i] = 0.25 * (before + 2.0 * line[i] + after) - background_1;
  }
  return smooth;
}

// First and last pixel of the unbroken stretch round `peak` at or above `level`.
struct Stretch {
  int first = 0;
  int last = 0;
  int width() const { return last - first + 1; }
};
Stretch StretchAbove(const std::vector<double>& smooth, int peak, double level_1) {
  Stretch stretch{peak, peak};
  while (stretch.first > 0 && smooth[static_cast<size_t>(stretch.first - 1)] >= level_1) {
    --stretch.first;
  }
  while (stretch.last + 1 < static_cast<int>(smooth.size()) &&
         smooth[static_cast<size_t>(stretch.last + 1)] >= level_1) {
    ++stretch.last;
  }
  return stretch;
}

// Width of the profile at half its height between pixels, as a Gaussian's standard deviation.
double WidthAsSigma(std::span<const uint8_t> line, const Stretch& half, double half_level_1) {
  const auto crossing = [&](int inside, int outside) {
    if (outside < 0 || outside >= static_cast<int>(line.size())) return 0.5;
    const double in_1 = line[static_cast<size_t>(inside)] - half_level_1;
    const double out_1 = line[static_cast<size_t>(outside)] - half_level_1;
    return in_1 > out_1 ? std::clamp(in_1 / (in_1 - out_1), 0.0, 1.0) : 0.5;
  };
  const double full_width_px = half.last - half.first + crossing(half.first, half.first - 1) +
                               crossing(half.last, half.last + 1);
  return full_width_px / 2.3548;
}

// Equation 3.6 in a window, weighing what rises above `base_level_1`.
double Centroid(std::span<const uint8_t> line, int first, int last, double base_level_1) {
  double weight_sum = 0.0;
  double index_sum = 0.0;
  for (int i = first; i <= last; ++i) {
    const double weight = line[static_cast<size_t>(i)] - base_level_1;
    if (weight <= 0.0) continue;
    weight_sum += weight;
    index_sum += weight * i;
  }
  return weight_sum > 0.0 ? index_sum / weight_sum : 0.5 * (first + last);
}

// The level the stripe stands on in its neighbourhood: light scattered round a saturated stripe, or
// what the subtraction of the background left over. The median, as long as the stripe fills less
// than half.
double Pedestal(std::span<const uint8_t> line, int middle, int reach) {
  const int first = std::max(0, middle - reach);
  const int last = std::min(static_cast<int>(line.size()) - 1, middle + reach);
  std::vector<uint8_t> levels(line.begin() + first, line.begin() + last + 1);
  const auto median = levels.begin() + static_cast<ptrdiff_t>(levels.size() / 2);
  std::nth_element(levels.begin(), median, levels.end());
  return *median;
}

// One bright spot, `peak` being its brightest pixel after smoothing. Blanks what it covers in
// `smooth`.
PeakCandidate MeasureCandidate(std::span<const uint8_t> line, int peak,
                               const Background& background, double threshold_1,
                               const PeakOptions& options, std::vector<double>* smooth) {
  const int length = static_cast<int>(line.size());
  const double peak_level_1 = (*smooth)[static_cast<size_t>(peak)];
  const Stretch crest = StretchAbove(*smooth, peak, 0.9 * peak_level_1);
  const int middle = (crest.first + crest.last) / 2;
  const double pedestal_1 =
      std::max(0.0, Pedestal(line, middle, options.max_width_px) - background.level_1);
  const double height_1 = peak_level_1 - pedestal_1;
  const Stretch half = StretchAbove(*smooth, peak, pedestal_1 + 0.5 * height_1);
  const Stretch foot = StretchAbove(*smooth, peak, pedestal_1 + options.base_fraction_1 * height_1);
  const int reach = std::max(options.half_window_px, half.width());
  const int center = (half.first + half.last) / 2;

  PeakCandidate candidate;
  candidate.position_px =
      Centroid(line, std::max({0, center - reach, foot.first}),
               std::min({length - 1, center + reach, foot.last}),
               background.level_1 + pedestal_1 + options.base_fraction_1 * height_1);
  candidate.peak_1 = height_1;
  candidate.sigma_px = WidthAsSigma(line, half, background.level_1 + pedestal_1 + 0.5 * height_1);
  candidate.too_wide = half.width() > options.max_width_px || height_1 < threshold_1;
  std::fill(smooth->begin() + std::max(0, std::min(center - reach, half.first)),
            smooth->begin() + std::min(length - 1, std::max(center + reach, half.last)) + 1, 0.0);
  return candidate;
}

// The bright spots of one line, brightest first.
void FindCandidates(int line_index, std::span<const uint8_t> line, const Background& background,
                    double threshold_1, const PeakOptions& options,
                    std::vector<PeakCandidate>* candidates) {
  std::vector<double> smooth = Smooth(line, background.level_1);
  for (int found = 0; found < options.max_candidates; ++found) {
    const auto brightest = std::max_element(smooth.begin(), smooth.end());
    if (*brightest < threshold_1) return;
    candidates->push_back(MeasureCandidate(line, static_cast<int>(brightest - smooth.begin()),
                                           background, threshold_1, options, &smooth));
    candidates->back().line = line_index;
  }
}

// Takes out the pieces that are too faint beside the rest of the stripe.
void DropFaintPieces(const std::vector<PeakCandidate>& candidates, double min_relative_peak_1,
                     std::vector<std::vector<size_t>>* pieces) {
  std::vector<double> peaks;
  for (const std::vector<size_t>& piece : *pieces) {
    for (const size_t index : piece) peaks.push_back(candidates[index].peak_1);
  }
  if (peaks.empty()) return;
  const auto median = peaks.begin() + static_cast<ptrdiff_t>(peaks.size() / 2);
  std::nth_element(peaks.begin(), median, peaks.end());
  const double least_1 = min_relative_peak_1 * *median;
  std::erase_if(*pieces, [&](const std::vector<size_t>& piece) {
    double sum = 0.0;
    for (const size_t index : piece) sum += candidates[index].peak_1;
    return sum < least_1 * static_cast<double>(piece.size());
  });
}

// How much stripe there is on both sides of a candidate on its piece: the light of the neighbours.
std::vector<double> Support(const std::vector<PeakCandidate>& candidates,
                            const std::vector<std::vector<size_t>>& pieces) {
  constexpr int kReach = 20;
  std::vector<double> support(candidates.size(), 0.0);
  for (const std::vector<size_t>& piece : pieces) {
    size_t first = 0;
    size_t end = 0;
    double sum = 0.0;
    for (const size_t index : piece) {
      const int line = candidates[index].line;
      while (end < piece.size() && candidates[piece[end]].line <= line + kReach) {
        sum += candidates[piece[end++]].peak_1;
      }
      while (candidates[piece[first]].line < line - kReach)
        sum -= candidates[piece[first++]].peak_1;
      support[index] = sum;
    }
  }
  return support;
}

// Which of a line's candidates [begin, end) is the stripe, or why none.
StripePeak Choose(int line, const std::vector<PeakCandidate>& candidates,
                  const std::vector<double>& support, size_t begin, size_t end) {
  constexpr double kEqualRight = 0.8;
  StripePeak result;
  result.pixel = line;
  if (begin == end) return result;  // too faint
  const bool all_wide = std::all_of(candidates.begin() + static_cast<ptrdiff_t>(begin),
                                    candidates.begin() + static_cast<ptrdiff_t>(end),
                                    [](const PeakCandidate& c) { return c.too_wide; });
  size_t best = begin;
  double second = 0.0;
  for (size_t k = begin + 1; k < end; ++k) {
    if (support[k] > support[best]) {
      second = support[best];
      best = k;
    } else {
      second = std::max(second, support[k]);
    }
  }
  if (support[best] <= 0.0) {
    result.reason = all_wide ? PeakReason::kTooWide : PeakReason::kSpeck;
  } else if (second > kEqualRight * support[best]) {
    result.reason = PeakReason::kAmbiguous;
  } else {
    const PeakCandidate& chosen = candidates[best];
    result = {line, PeakReason::kFound, chosen.position_px, chosen.peak_1, chosen.sigma_px};
  }
  return result;
}

}  // namespace

std::optional<std::string> PeakOptions::Validate() const {
  if (!(min_peak_1 > 0.0)) return "min_peak_1 must be positive";
  if (!(noise_factor_1 >= 0.0)) return "noise_factor_1 must not be negative";
  if (!(base_fraction_1 >= 0.0 && base_fraction_1 < 0.5))
    return "base_fraction_1 must be in [0, 0.5)";
  if (half_window_px < 1) return "half_window_px must be at least 1";
  if (max_width_px < 1) return "max_width_px must be at least 1";
  if (max_step_px < 1 || max_gap_px < 0)
    return "max_step_px must be positive, max_gap_px not negative";
  if (min_piece_px < 1) return "min_piece_px must be at least 1";
  if (!(min_relative_peak_1 >= 0.0 && min_relative_peak_1 < 1.0)) {
    return "min_relative_peak_1 must be in [0, 1)";
  }
  if (max_candidates < 1) return "max_candidates must be at least 1";
  return std::nullopt;
}

std::string_view ToString(PeakReason reason) {
  switch (reason) {
    case PeakReason::kFound:
      return "found";
    case PeakReason::kTooFaint:
      return "too_faint";
    case PeakReason::kTooWide:
      return "too_wide";
    case PeakReason::kSpeck:
      return "speck";
    case PeakReason::kAmbiguous:
      return "ambiguous";
  }
  return "unknown";
}

std::vector<StripePeak> FindStripePeaks(const sensor::Image& laser_light, sensor::Laser laser,
                                        const PeakOptions& options) {
  const std::optional<std::string> error = options.Validate();
  Require(!error, "PeakOptions: " + error.value_or(""));
  Require(laser != sensor::Laser::kNone, "FindStripePeaks: which laser?");
  Require(laser_light.format == sensor::PixelFormat::kGray8 && laser_light.width_px > 0 &&
              laser_light.height_px > 0 && laser_light.row_stride_bytes >= laser_light.width_px &&
              laser_light.data.size() >= static_cast<size_t>(laser_light.row_stride_bytes) *
                                             static_cast<size_t>(laser_light.height_px),
          "FindStripePeaks: a grey image is needed, with data that fits its size");

  const Lines lines = AcrossStripe(laser_light, laser);
  const Background background = MeasureBackground(lines);
  const double threshold_1 =
      std::max(options.min_peak_1, options.noise_factor_1 * background.noise_1);

  std::vector<PeakCandidate> candidates;
  std::vector<size_t> first_of_line;
  for (int line = 0; line < lines.count; ++line) {
    first_of_line.push_back(candidates.size());
    FindCandidates(line, lines.Line(line), background, threshold_1, options, &candidates);
  }
  first_of_line.push_back(candidates.size());

  std::vector<std::vector<size_t>> pieces =
      LinkPieces(candidates, {options.max_step_px, options.max_gap_px, options.min_piece_px});
  DropFaintPieces(candidates, options.min_relative_peak_1, &pieces);
  const std::vector<double> support = Support(candidates, pieces);

  std::vector<StripePeak> peaks;
  for (int line = 0; line < lines.count; ++line) {
    peaks.push_back(Choose(line, candidates, support, first_of_line[static_cast<size_t>(line)],
                           first_of_line[static_cast<size_t>(line) + 1]));
  }
  return peaks;
}

}  // namespace geon::rangefinder
