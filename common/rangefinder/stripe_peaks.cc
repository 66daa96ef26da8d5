#include "rangefinder/stripe_peaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/contracts.h"
#include "rangefinder/stripe_candidates.h"
#include "rangefinder/stripe_pieces.h"

namespace geon::rangefinder {
namespace {

// Takes out the pieces that are too faint beside the rest of the stripe.
void DropFaintPieces(const std::vector<PeakCandidate>& candidates, double min_relative_peak_1,
                     std::vector<std::vector<size_t>>* pieces) {
  // The median to a grey level.
  std::array<size_t, 256> count{};
  size_t all = 0;
  for (const std::vector<size_t>& piece : *pieces) {
    all += piece.size();
    for (const size_t index : piece) {
      ++count[static_cast<size_t>(std::clamp(candidates[index].fit.peak_1, 0.0, 255.0))];
    }
  }
  size_t median_1 = 0;
  for (size_t below = count[0]; 2 * below < all; below += count[median_1]) ++median_1;
  const double least_1 = min_relative_peak_1 * static_cast<double>(median_1);
  std::erase_if(*pieces, [&](const std::vector<size_t>& piece) {
    double sum = 0.0;
    for (const size_t index : piece) sum += std::min(candidates[index].fit.peak_1, 255.0);
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
        sum += std::min(candidates[piece[end++]].fit.peak_1, 255.0);
      }
      while (candidates[piece[first]].line < line - kReach) {
        sum -= std::min(candidates[piece[first++]].fit.peak_1, 255.0);
      }
      support[index] = sum;
    }
  }
  return support;
}

// Which of a line's candidates [begin, end) is the stripe, or why none.
struct Choice {
  PeakReason reason = PeakReason::kTooFaint;
  size_t candidate = 0;
};
Choice Choose(const std::vector<PeakCandidate>& candidates, const std::vector<double>& support,
              size_t begin, size_t end) {
  constexpr double kEqualRight = 0.8;
  if (begin == end) return {};
  size_t best = begin;
  double second = 0.0;
  bool all_wide = candidates[begin].too_wide;
  for (size_t k = begin + 1; k < end; ++k) {
    all_wide = all_wide && candidates[k].too_wide;
    if (support[k] > support[best]) {
      second = support[best];
      best = k;
    } else {
      second = std::max(second, support[k]);
    }
  }
  if (support[best] <= 0.0) return {all_wide ? PeakReason::kTooWide : PeakReason::kSpeck, 0};
  if (second > kEqualRight * support[best]) return {PeakReason::kAmbiguous, 0};
  return {PeakReason::kFound, best};
}

// The light of a profile, but for a factor.
double Light(const PeakCandidate& candidate) {
  return candidate.fit.peak_1 * candidate.fit.width_px;
}

// How much of an image's lines, and of the light that may be a stripe, the peaks make up.
double StripeShare(const std::vector<const PeakCandidate*>& found, int lines,
                   const std::vector<PeakCandidate>& candidates) {
  double chosen = 0.0;
  for (const PeakCandidate* candidate : found) chosen += Light(*candidate);
  double all = 0.0;
  for (const PeakCandidate& candidate : candidates) all += Light(candidate);
  return static_cast<double>(found.size()) / lines * (chosen / all);
}

// How many grey levels of variance a grey level of laser light brings: shot noise, and whatever
// else makes the profiles differ from Gaussians. From the residuals of some of the fits: the median
// over groups, so that a few bad fits do not count.
double MeasureGain(const LineView& image, const std::vector<const PeakCandidate*>& found,
                   double noise_1) {
  constexpr size_t kGroups = 7;
  constexpr size_t kGroupSize = 6;
  std::array<double, kGroups> gains{};
  for (size_t group = 0; group < kGroups; ++group) {
    double excess = 0.0;
    double light = 0.0;
    for (size_t k = 0; k < kGroupSize; ++k) {
      const size_t which = (group * kGroupSize + k) * found.size() / (kGroups * kGroupSize);
      const Misfit misfit = MeasureMisfit(image, found[which]->line, found[which]->fit);
      excess += misfit.square_sum_1 - misfit.freedom * noise_1 * noise_1;
      light += misfit.light_1;
    }
    gains[group] = light > 0.0 ? excess / light : 0.0;
  }
  std::nth_element(gains.begin(), gains.begin() + kGroups / 2, gains.end());
  return std::max(0.0, gains[kGroups / 2]);
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
  if (!(min_stripe_share_1 >= 0.0 && min_stripe_share_1 < 1.0)) {
    return "min_stripe_share_1 must be in [0, 1)";
  }
  if (max_candidates < 1) return "max_candidates must be at least 1";
  return std::nullopt;
}

std::string_view ToString(PeakMethod method) {
  return method == PeakMethod::kCentroid ? "centroid" : "gaussian";
}

std::optional<PeakMethod> PeakMethodFromString(std::string_view name) {
  for (const PeakMethod method : {PeakMethod::kCentroid, PeakMethod::kGaussian}) {
    if (name == ToString(method)) return method;
  }
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
    case PeakReason::kNoStripe:
      return "no_stripe";
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

  const LineView image(laser_light, laser);
  const Background background = MeasureBackground(laser_light);
  const std::vector<PeakCandidate> candidates =
      FindCandidates(laser_light, laser, background, options);
  std::vector<std::vector<size_t>> pieces =
      LinkPieces(candidates, {options.max_step_px, options.max_gap_px, options.min_piece_px});
  DropFaintPieces(candidates, options.min_relative_peak_1, &pieces);
  const std::vector<double> support = Support(candidates, pieces);

  std::vector<StripePeak> peaks(static_cast<size_t>(image.lines));
  std::vector<const PeakCandidate*> found;
  found.reserve(peaks.size());
  size_t begin = 0;
  for (int line = 0; line < image.lines; ++line) {
    size_t end = begin;
    while (end < candidates.size() && candidates[end].line == line) ++end;
    const Choice choice = Choose(candidates, support, begin, end);
    StripePeak& peak = peaks[static_cast<size_t>(line)];
    peak.pixel = line;
    peak.reason = choice.reason;
    if (choice.reason == PeakReason::kFound) found.push_back(&candidates[choice.candidate]);
    begin = end;
  }
  if (found.empty()) return peaks;
  if (options.min_stripe_share_1 > 0.0 &&
      StripeShare(found, image.lines, candidates) < options.min_stripe_share_1) {
    for (StripePeak& peak : peaks) peak.reason = PeakReason::kNoStripe;
    return peaks;
  }

  const double gain_1 = MeasureGain(image, found, background.noise_1);
  for (const PeakCandidate* candidate : found) {
    const ProfileFit& fit = candidate->fit;
    StripePeak& peak = peaks[static_cast<size_t>(candidate->line)];
    peak.position_px = fit.position_px;
    peak.peak_1 = fit.peak_1;
    peak.width_px = fit.width_px;
    peak.sigma_px =
        std::sqrt(fit.per_noise * background.noise_1 * background.noise_1 + fit.per_gain * gain_1);
  }
  return peaks;
}

}  // namespace geon::rangefinder
