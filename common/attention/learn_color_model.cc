#include "attention/learn_color_model.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "attention/fit_color_region.h"
#include "attention/rgb_image.h"

namespace geon::attention {
namespace {

using Histogram = Eigen::ArrayXXd;

Histogram EmptyHistogram() { return Histogram::Zero(kChromaticityBins, kChromaticityBins); }

// What the pictures hold on either side.
struct Lesson {
  Histogram target_1 = EmptyHistogram();      // shares of each picture, summed
  Histogram background_1 = EmptyHistogram();  // the same
  int target_pixels = 0;
  int background_pixels = 0;
  int clipped_target_pixels = 0;
  int usable_target_pixels = 0;
  Eigen::Vector3d rgb_sum_1 = Eigen::Vector3d::Zero();  // of these
};

bool IsClipped(const Rgb& rgb, const TeachingOptions& options) {
  return std::max({rgb.red, rgb.green, rgb.blue}) >= options.clipped_level;
}

bool IsUsable(const Rgb& rgb, const TeachingOptions& options) {
  return std::max({rgb.red, rgb.green, rgb.blue}) >= options.dark_level && !IsClipped(rgb, options);
}

// Calls visit(colour, whether it is target) for every pixel.
template <typename Visit>
void VisitPixels(const TeachingSample& sample, Visit visit) {
  const RgbImage image(sample.image);
  const auto width = static_cast<size_t>(image.width_px());
  Require(sample.is_target.size() == width * static_cast<size_t>(image.height_px()),
          "TeachingSample: the mask has not the image's size");
  for (int v = 0; v < image.height_px(); ++v) {
    for (int u = 0; u < image.width_px(); ++u) {
      const size_t pixel = static_cast<size_t>(v) * width + static_cast<size_t>(u);
      visit(image.At(u, v), sample.is_target[pixel] != 0);
    }
  }
}

void Collect(const TeachingSample& sample, const TeachingOptions& options, Lesson* lesson) {
  Histogram target = EmptyHistogram(), background = EmptyHistogram();
  VisitPixels(sample, [&](const Rgb& rgb, bool is_target) {
    ++(is_target ? lesson->target_pixels : lesson->background_pixels);
    if (is_target && IsClipped(rgb, options)) ++lesson->clipped_target_pixels;
    if (!IsUsable(rgb, options)) return;
    const ChromaticityBin bin = BinOf(rgb);
    (is_target ? target : background)(bin.red, bin.green) += 1.0;
    if (!is_target) return;
    ++lesson->usable_target_pixels;
    lesson->rgb_sum_1 += Eigen::Vector3d(rgb.red, rgb.green, rgb.blue);
  });
  lesson->target_1 += target / std::max(1.0, target.sum());
  lesson->background_1 += background / std::max(1.0, background.sum());
}

// Every bin keeps half and gives a quarter to either neighbour, along both axes.
Histogram Spread(const Histogram& histogram) {
  constexpr Eigen::Index kRest = kChromaticityBins - 1;
  Histogram along_red = 0.5 * histogram;
  along_red.topRows(kRest) += 0.25 * histogram.bottomRows(kRest);
  along_red.bottomRows(kRest) += 0.25 * histogram.topRows(kRest);
  Histogram along_both = 0.5 * along_red;
  along_both.leftCols(kRest) += 0.25 * along_red.rightCols(kRest);
  along_both.rightCols(kRest) += 0.25 * along_red.leftCols(kRest);
  return along_both;
}

// Spread by the noise that a camera has at least (one bin), and scaled to a sum of 1.
Histogram Smoothed(const Histogram& histogram) {
  const Histogram smooth = Spread(Spread(histogram));
  const double sum = smooth.sum();
  return sum > 0.0 ? Histogram(smooth / sum) : smooth;
}

// All colours alike.
Histogram EvenHistogram() {
  Histogram even = EmptyHistogram();
  for (int red = 0; red < kChromaticityBins; ++red) {
    even.row(red).head(kChromaticityBins - red) = 1.0;
  }
  return even / even.sum();
}

// How the model does on the pixels it was learned from.
void Examine(const ColorModel& model, const std::vector<TeachingSample>& samples,
             const TeachingOptions& options, TeachingReport* report) {
  double taken = 0.0, targets = 0.0, right = 0.0;
  for (const TeachingSample& sample : samples) {
    VisitPixels(sample, [&](const Rgb& rgb, bool is_target) {
      if (!IsUsable(rgb, options)) return;
      const bool is_taken = model.Classify(rgb) == ColorClass::kTarget;
      taken += is_taken ? 1.0 : 0.0;
      targets += is_target ? 1.0 : 0.0;
      right += is_taken && is_target ? 1.0 : 0.0;
    });
  }
  report->recall_1 = right / targets;
  report->precision_1 = taken > 0.0 ? right / taken : 0.0;
}

std::vector<std::string> Warnings(const TeachingReport& report) {
  const auto percent = [](double share) {
    return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " %";
  };
  std::vector<std::string> warnings;
  if (report.clipped_fraction_1 > 0.1) {
    warnings.push_back(percent(report.clipped_fraction_1) +
                       " of the target is clipped: lower the exposure and teach again");
  }
  if (report.precision_1 < 0.8) {
    warnings.push_back("close to the background's colour: " + percent(1.0 - report.precision_1) +
                       " of what the model takes is not target");
  }
  if (report.recall_1 < 0.6) {
    warnings.push_back("only " + percent(report.recall_1) +
                       " of the target has the taught colour: draw the box or mask tighter");
  }
  return warnings;
}

}  // namespace

std::optional<std::string> TeachingOptions::Validate() const {
  if (dark_level < 1 || clipped_level <= dark_level || clipped_level > 256) {
    return "levels must keep 1 <= dark_level < clipped_level <= 256";
  }
  if (min_samples < 3) return "min_samples must be at least 3";
  if (!(background_weight_1 > 0.0)) return "background_weight_1 must be positive";
  if (!(unseen_1 >= 0.0 && unseen_1 <= 1.0)) return "unseen_1 must be from 0 to 1";
  if (!(tolerance_1 >= 0.0 && tolerance_1 < 1.0)) return "tolerance_1 must be from 0 to below 1";
  return std::nullopt;
}

Result<LearnedColor> LearnColorModel(const std::vector<TeachingSample>& samples,
                                     const std::string& name, const TeachingOptions& options) {
  const std::optional<std::string> error = options.Validate();
  Require(!error, "TeachingOptions: " + error.value_or(""));

  Lesson lesson;
  for (const TeachingSample& sample : samples) Collect(sample, options, &lesson);
  if (lesson.usable_target_pixels < options.min_samples) {
    return Status::Error("only " + std::to_string(lesson.usable_target_pixels) + " of " +
                         std::to_string(lesson.target_pixels) +
                         " target pixels are neither clipped nor too dark, at least " +
                         std::to_string(options.min_samples) +
                         " are needed: take more light, less exposure or a larger region");
  }

  const Histogram background_1 =
      (1.0 - options.unseen_1) * Smoothed(lesson.background_1) + options.unseen_1 * EvenHistogram();
  FittedRegion fitted = FitColorRegion(
      Smoothed(lesson.target_1) - options.background_weight_1 * background_1, options.tolerance_1);
  constexpr double kLeastWorth_1 = 0.1;
  if (fitted.worth_1 < kLeastWorth_1) {
    return Status::Error(
        "the target's colours are as frequent in the rest of the picture: no colour marks it");
  }
  // Darkness has no chromaticity: a grey pixel's noise would put it anywhere.
  fitted.region.half_spaces.push_back({1.0, 1.0, 1.0, 2.0 * options.dark_level});

  LearnedColor learned;
  learned.model = {name, {fitted.region}, {}, options.dark_level, options.clipped_level};
  TeachingReport& report = learned.report;
  report.target_pixels = lesson.target_pixels;
  report.background_pixels = lesson.background_pixels;
  Examine(learned.model, samples, options, &report);
  report.clipped_fraction_1 =
      static_cast<double>(lesson.clipped_target_pixels) / lesson.target_pixels;
  const Eigen::Vector3d mean_rgb = lesson.rgb_sum_1 / lesson.usable_target_pixels;
  report.mean_color = HsiFromRgb({static_cast<uint8_t>(std::lround(mean_rgb.x())),
                                  static_cast<uint8_t>(std::lround(mean_rgb.y())),
                                  static_cast<uint8_t>(std::lround(mean_rgb.z()))});
  report.warnings = Warnings(report);
  return learned;
}

}  // namespace geon::attention
