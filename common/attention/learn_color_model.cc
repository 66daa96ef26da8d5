#include "attention/learn_color_model.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "attention/rgb_image.h"

namespace geon::attention {
namespace {

// One usable pixel: where it lies in the plane of chromaticity, and on which side of the lesson.
struct Sample {
  Eigen::Vector2d chromaticity_1;
  double luminance_1 = 0.0;
  bool is_target = false;
};

struct Lesson {
  std::vector<Sample> samples;
  int target_pixels = 0;
  int background_pixels = 0;
  int clipped_target_pixels = 0;
  Eigen::Vector3d rgb_sum_1 = Eigen::Vector3d::Zero();
  int usable_target_pixels = 0;
};

void Collect(const TeachingSample& teaching, const TeachingOptions& options, Lesson* lesson) {
  const RgbImage image(teaching.image);
  Require(teaching.is_target.size() ==
              static_cast<size_t>(image.width_px()) * static_cast<size_t>(image.height_px()),
          "TeachingSample: the mask has not the image's size");
  for (int v = 0; v < image.height_px(); ++v) {
    for (int u = 0; u < image.width_px(); ++u) {
      const Rgb rgb = image.At(u, v);
      const bool is_target =
          teaching.is_target[static_cast<size_t>(v) * static_cast<size_t>(image.width_px()) +
                             static_cast<size_t>(u)] != 0;
      ++(is_target ? lesson->target_pixels : lesson->background_pixels);
      const bool clipped = std::max({rgb.red, rgb.green, rgb.blue}) >= options.clipped_level;
      if (clipped && is_target) ++lesson->clipped_target_pixels;
      const Yiq yiq = YiqFromRgb(rgb);
      if (clipped || yiq.luminance_1 < options.min_luminance_1) continue;
      lesson->samples.push_back(
          {{yiq.in_phase_1 / yiq.luminance_1, yiq.quadrature_1 / yiq.luminance_1},
           yiq.luminance_1,
           is_target});
      if (!is_target) continue;
      ++lesson->usable_target_pixels;
      lesson->rgb_sum_1 += Eigen::Vector3d(rgb.red, rgb.green, rgb.blue);
    }
  }
}

// A coarse histogram of chromaticity for either side of the lesson. I/Y and Q/Y of any colour lie
// between -2.9 and 2.8 (equations 4.4-4.6).
class ChromaticityHistogram {
 public:
  explicit ChromaticityHistogram(const std::vector<Sample>& samples) {
    for (const Sample& sample : samples) {
      ++(sample.is_target ? target_ : background_)[Bin(sample.chromaticity_1)];
      ++(sample.is_target ? targets_ : backgrounds_);
    }
  }
  // Whether a colour is a mark of the target: a larger share of the target than twice its share of
  // the background. A box drawn round a target holds some background too, which this leaves out.
  bool MarksTarget(const Eigen::Vector2d& chromaticity_1) const {
    const size_t bin = Bin(chromaticity_1);
    return target_[bin] * std::max(1.0, backgrounds_) > 2.0 * background_[bin] * targets_;
  }

 private:
  static constexpr int kBins = 96;
  static constexpr double kSpan = 3.0;
  static size_t Bin(const Eigen::Vector2d& chromaticity_1) {
    const auto index = [](double value) {
      return std::clamp(static_cast<int>((value + kSpan) / (2.0 * kSpan) * kBins), 0, kBins - 1);
    };
    return static_cast<size_t>(index(chromaticity_1.x()) * kBins + index(chromaticity_1.y()));
  }
  std::vector<double> target_ = std::vector<double>(kBins * kBins, 0.0);
  std::vector<double> background_ = std::vector<double>(kBins * kBins, 0.0);
  double targets_ = 0.0;
  double backgrounds_ = 0.0;
};

struct Ellipse {
  Eigen::Vector2d mean_1 = Eigen::Vector2d::Zero();
  Eigen::Matrix2d inverse_1 = Eigen::Matrix2d::Identity();
  double Distance(const Eigen::Vector2d& chromaticity_1) const {
    const Eigen::Vector2d d = chromaticity_1 - mean_1;
    return std::sqrt(d.dot(inverse_1 * d));
  }
};

Ellipse FitEllipse(const std::vector<const Sample*>& core, double noise_floor_1) {
  Ellipse ellipse;
  for (const Sample* sample : core) ellipse.mean_1 += sample->chromaticity_1;
  ellipse.mean_1 /= static_cast<double>(core.size());
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const Sample* sample : core) {
    const Eigen::Vector2d d = sample->chromaticity_1 - ellipse.mean_1;
    covariance += d * d.transpose();
  }
  covariance /= static_cast<double>(core.size());
  covariance += noise_floor_1 * noise_floor_1 * Eigen::Matrix2d::Identity();
  ellipse.inverse_1 = covariance.inverse();
  return ellipse;
}

// The ellipse of what marks the target, without its stragglers (beyond 3 standard deviations,
// twice).
Ellipse FitCore(std::vector<const Sample*> core, double noise_floor_1) {
  Ellipse ellipse = FitEllipse(core, noise_floor_1);
  for (int round = 0; round < 2; ++round) {
    std::vector<const Sample*> kept;
    std::copy_if(core.begin(), core.end(), std::back_inserter(kept), [&](const Sample* sample) {
      return ellipse.Distance(sample->chromaticity_1) <= 3.0;
    });
    if (kept.empty()) break;
    core = std::move(kept);
    ellipse = FitEllipse(core, noise_floor_1);
  }
  return ellipse;
}

// The ellipse as half-spaces through black: a polygon of as large an area, as sums of the equations
// 4.4-4.6 times Y > 0, and the darkest colour it holds.
HalfSpaceColor PolygonCone(const Ellipse& ellipse, double reach_1, double min_luminance_1) {
  constexpr int kSides = 12;
  constexpr double kHalfSide_rad = std::numbers::pi / kSides;
  const double apothem_1 =
      reach_1 * std::sqrt(std::numbers::pi / (kSides * std::tan(kHalfSide_rad)));
  const Eigen::Matrix2d whitening = ellipse.inverse_1.llt().matrixU();
  Eigen::Matrix3d yiq_from_rgb;  // columns: what one unit of red, green or blue adds
  const Rgb units[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int channel = 0; channel < 3; ++channel) {
    const Yiq yiq = YiqFromRgb(units[channel]);
    yiq_from_rgb.col(channel) << yiq.luminance_1, yiq.in_phase_1, yiq.quadrature_1;
  }
  const Eigen::RowVector3d luminance = yiq_from_rgb.row(0);
  HalfSpaceColor cone;
  cone.half_spaces.push_back(
      WholeNumbered({luminance[0], luminance[1], luminance[2], min_luminance_1}));
  for (int side = 0; side < kSides; ++side) {
    const double angle_rad = 2.0 * kHalfSide_rad * side;
    const Eigen::RowVector2d normal =
        Eigen::RowVector2d(std::cos(angle_rad), std::sin(angle_rad)) * whitening;
    const Eigen::RowVector3d plane = (apothem_1 + normal.dot(ellipse.mean_1)) * luminance -
                                     normal * yiq_from_rgb.bottomRows<2>();
    cone.half_spaces.push_back(WholeNumbered({plane[0], plane[1], plane[2], 0.0}));
  }
  return cone;
}

struct Rim {
  double reach_1 = 0.0;
  double recall_1 = 0.0;
  double precision_1 = 0.0;
  double score_1 = -1.0;  // harmonic mean of the two
};

// The rim that tells target from background best.
Rim ChooseRim(const Lesson& lesson, const Ellipse& ellipse, double min_luminance_1,
              const TeachingOptions& options) {
  constexpr double kStep = 0.1;
  std::array<double, 2> taken = {0.0, 0.0};  // background, target
  const auto steps = static_cast<size_t>(std::lround(options.max_reach_1 / kStep));
  std::vector<std::array<double, 2>> rings(steps + 1, {0.0, 0.0});
  for (const Sample& sample : lesson.samples) {
    const double ring = std::ceil(ellipse.Distance(sample.chromaticity_1) / kStep);
    if (sample.luminance_1 < min_luminance_1 || ring > static_cast<double>(steps)) continue;
    rings[static_cast<size_t>(ring)][sample.is_target ? 1 : 0] += 1.0;
  }
  std::vector<Rim> rims;
  for (size_t ring = 0; ring <= steps; ++ring) {
    taken[0] += rings[ring][0];
    taken[1] += rings[ring][1];
    const double reach_1 = static_cast<double>(ring) * kStep;
    if (reach_1 + 1e-9 < options.min_reach_1 || taken[1] <= 0.0) continue;
    const double recall_1 = taken[1] / lesson.usable_target_pixels;
    const double precision_1 = taken[1] / (taken[0] + taken[1]);
    const double score_1 = 2.0 * recall_1 * precision_1 / (recall_1 + precision_1);
    rims.push_back({reach_1, recall_1, precision_1, score_1});
  }
  Rim best;
  for (const Rim& rim : rims) best = rim.score_1 > best.score_1 ? rim : best;
  // As wide as costs next to nothing: other lights and other cameras' noise will need the room.
  constexpr double kNextToNothing = 0.995;
  const double enough_1 = kNextToNothing * best.score_1;
  for (const Rim& rim : rims) {
    if (rim.score_1 >= enough_1 && rim.reach_1 > best.reach_1) best = rim;
  }
  return best;
}

// Down to half the brightness of the darkest taught hundredth: shades of the target stay in.
double LuminanceLimit(const std::vector<const Sample*>& core, const TeachingOptions& options) {
  std::vector<double> luminance_1;
  luminance_1.reserve(core.size());
  for (const Sample* sample : core) luminance_1.push_back(sample->luminance_1);
  const auto darkest = luminance_1.begin() + static_cast<ptrdiff_t>(luminance_1.size() / 100);
  std::nth_element(luminance_1.begin(), darkest, luminance_1.end());
  return std::max(options.min_luminance_1, 0.5 * *darkest);
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
  if (min_samples < 3) return "min_samples must be at least 3";
  if (!(min_reach_1 > 0.0) || !(max_reach_1 >= min_reach_1)) {
    return "min_reach_1 must be positive and not above max_reach_1";
  }
  if (!(noise_floor_1 > 0.0)) return "noise_floor_1 must be positive";
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

  const ChromaticityHistogram histogram(lesson.samples);
  std::vector<const Sample*> core;
  for (const Sample& sample : lesson.samples) {
    if (sample.is_target && histogram.MarksTarget(sample.chromaticity_1)) core.push_back(&sample);
  }
  if (static_cast<int>(core.size()) < options.min_samples) {
    return Status::Error(
        "the target's colours are as frequent in the rest of the picture: no colour marks it");
  }
  const Ellipse ellipse = FitCore(core, options.noise_floor_1);
  const double min_luminance_1 = LuminanceLimit(core, options);
  const Rim rim = ChooseRim(lesson, ellipse, min_luminance_1, options);
  if (rim.score_1 < 0.0) {
    return Status::Error("no rim of the colour keeps a taught pixel: the samples are inconsistent");
  }

  LearnedColor learned;
  learned.model = {name, {PolygonCone(ellipse, rim.reach_1, min_luminance_1)}, {}};
  TeachingReport& report = learned.report;
  report.target_pixels = lesson.target_pixels;
  report.background_pixels = lesson.background_pixels;
  report.recall_1 = rim.recall_1;
  report.precision_1 = rim.precision_1;
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
