#include "recognition/label_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "recognition/profile_curve.h"
#include "recognition/stripe_blocks.h"
#include "recognition/target_extent.h"

namespace geon::recognition {
namespace {

// Logarithms of likelihoods.
constexpr double kOnTarget = 1.2;       // 1 / 0.3 m: a target's point may be anywhere near it
constexpr double kUnknown = 0.2;        // background that lies on no plane
constexpr double kFarBelow = -8.0;      // support: of a point far below it
constexpr double kChange = -5.0;        // from target to background or back ...
constexpr double kChangeAtJump = -1.0;  // ... where the stripe jumps
constexpr double kFarSigmas = 8.0;      // a point so far off a plane does not lie on it
constexpr double kNormal = -0.919;      // -log(sqrt(2 pi))
constexpr double kJump_m = 0.015;       // and eight sigmas: from a point to the next
// A target's point may lack its colour (a highlight, something before it), and background may lie
// hidden behind the target.
constexpr double kUncolored_1 = 0.05;
constexpr double kColored_1 = 0.10;

// Where target and support meet.
constexpr size_t kSlopePoints = 20;  // so many of the target tell its slope
constexpr size_t kFewestForSlope = 6;
constexpr double kRise = 6.0;  // sigmas that they must rise by

constexpr double kBeyond_1 = 0.04;  // of the target's box: how far off a run's middle may be

constexpr double kLeastFlat_m = 0.0004;
constexpr double kKnownFlat_m = 0.0033;  // thesis: 1 cm, as three sigmas

// Heights above the support and what they are worth.
struct Heights {
  std::vector<double> above_m;
  std::vector<double> sigma_m;
};

Heights FindHeights(const RegionProfile& part, const SupportPlane& support) {
  Heights heights;
  heights.above_m.reserve(part.p_L_m.size());
  heights.sigma_m.reserve(part.p_L_m.size());
  const double flat_m = std::max(support.sigma_m, kLeastFlat_m);
  const double eye_m = support.Above(part.camera.p_LB_m);
  for (size_t i = 0; i < part.p_L_m.size(); ++i) {
    const double above_m = support.Above(part.p_L_m[i]);
    heights.above_m.push_back(above_m);
    const double noise_m = part.noise_m * (eye_m - above_m) / part.depth_m[i];
    heights.sigma_m.push_back(std::sqrt(flat_m * flat_m + noise_m * noise_m));
  }
  return heights;
}

double LogNormal(double off_m, double sigma_m) {
  const double share = off_m / sigma_m;
  if (share * share > kFarSigmas * kFarSigmas) return -kFarSigmas;  // most points
  return kNormal - std::log(sigma_m) - 0.5 * share * share;
}

// What a point says: log likelihood of target less that of background.
double LogRatio(double above_m, double sigma_m, double wall_log) {
  double target = kOnTarget, support = LogNormal(above_m, sigma_m);
  if (above_m < 0.0) {
    target -= 0.5 * above_m * above_m / (sigma_m * sigma_m);
    support = std::max(support, kFarBelow);
    target = std::max(target, kFarBelow - 3.0);
  }
  return target - std::max({support, wall_log, kUnknown});
}

// Log likelihood of a point that lies on the wall.
double WallLog(const WallPlane& wall, const RegionProfile& part, size_t i) {
  const Eigen::Vector3d ray_L = part.p_L_m[i] - part.camera.p_LB_m;
  const double slant_1 = std::abs(wall.normal_L.dot(ray_L)) / part.depth_m[i];
  return LogNormal(wall.Before(part.p_L_m[i]),
                   wall.sigma_m + kLeastFlat_m + part.noise_m * slant_1);
}

double LogColorRatio(double on_color_1) {
  const auto ratio = [](double p_1) {
    return std::log((kUncolored_1 + (1.0 - kUncolored_1) * p_1) /
                    (kColored_1 + (1.0 - kColored_1) * (1.0 - p_1)));
  };
  static const double none = ratio(0.0), all = ratio(1.0);  // of most points
  if (on_color_1 == 0.0 || on_color_1 == 1.0) return on_color_1 == 0.0 ? none : all;
  return ratio(on_color_1);
}

bool JumpsTo(const RegionProfile& part, size_t i) {
  const double jump_m = kJump_m + 8.0 * part.noise_m;
  return (part.p_L_m[i] - part.p_L_m[i - 1]).squaredNorm() > jump_m * jump_m;
}

// The likeliest sequence of target (true) and background.
std::vector<bool> LikeliestLabels(std::span<const double> ratio, const RegionProfile& part) {
  const size_t n = ratio.size();
  std::vector<bool> label(n);
  if (n == 0) return label;
  // Best sums of the sequences that end in background (0) and target (1), and where they came from.
  std::vector<std::array<bool, 2>> from(n);
  std::array<double, 2> best = {0.0, ratio[0]};
  for (size_t i = 1; i < n; ++i) {
    const double change = JumpsTo(part, i) ? kChangeAtJump : kChange;
    from[i] = {best[1] + change > best[0], best[1] >= best[0] + change};
    best = {std::max(best[0], best[1] + change), std::max(best[1], best[0] + change) + ratio[i]};
  }
  bool state = best[1] > best[0];
  for (size_t i = n; i-- > 0;) {
    label[i] = state;
    if (i > 0) state = from[i][state ? 1 : 0];
  }
  return label;
}

std::vector<PointRange> FindRuns(const std::vector<bool>& label, const RegionProfile& part) {
  std::vector<PointRange> runs;
  for (size_t i = 0; i < label.size(); ++i) {
    if (!label[i]) continue;
    const bool goes_on = i > 0 && label[i - 1] && !JumpsTo(part, i);
    if (goes_on) {
      runs.back().end = i + 1;
    } else {
      runs.push_back({i, i + 1});
    }
  }
  return runs;
}

// A line through the heights of the target's points next to a border, against their number from it.
struct Slope {
  double at_border_m = 0.0;
  double per_point_m = 0.0;
};

// Nothing where they are too few or hardly rise. `step` leads from the border into the target.
std::optional<Slope> FindSlope(const Heights& heights, size_t border, std::ptrdiff_t step,
                               size_t run) {
  const size_t count = std::min(run, kSlopePoints);
  if (count < kFewestForSlope) return std::nullopt;
  double sum_k = 0.0, sum_h = 0.0, sum_kk = 0.0, sum_kh = 0.0;
  for (size_t k = 0; k < count; ++k) {
    const auto i = static_cast<std::ptrdiff_t>(border) + static_cast<std::ptrdiff_t>(k) * step;
    const double at = static_cast<double>(k), height_m = heights.above_m[static_cast<size_t>(i)];
    sum_k += at;
    sum_h += height_m;
    sum_kk += at * at;
    sum_kh += at * height_m;
  }
  const double n = static_cast<double>(count);
  const double slope_m = (n * sum_kh - sum_k * sum_h) / (n * sum_kk - sum_k * sum_k);
  if (slope_m * n < kRise * heights.sigma_m[border]) return std::nullopt;
  return Slope{(sum_h - slope_m * sum_k) / n, slope_m};
}

// Gives the target those points beyond a border that agree better with its slope than with the
// support. `step` leads from the border, a point of the target, out of it.
void MoveBorder(const Heights& heights, const RegionProfile& part, size_t border,
                std::ptrdiff_t step, size_t run, std::vector<bool>* label) {
  const std::optional<Slope> slope = FindSlope(heights, border, -step, run);
  if (!slope) return;
  const auto n = static_cast<std::ptrdiff_t>(label->size());
  double gain_m2 = 0.0, best_m2 = 0.0;
  std::ptrdiff_t best = 0;
  for (std::ptrdiff_t k = 1;; ++k) {
    const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(border) + k * step;
    if (i < 0 || i >= n || (*label)[static_cast<size_t>(i)]) break;
    if (JumpsTo(part, static_cast<size_t>(std::max(i, i - step)))) break;
    const double line_m = slope->at_border_m - slope->per_point_m * static_cast<double>(k);
    if (line_m <= 0.0) break;
    const double above_m = heights.above_m[static_cast<size_t>(i)];
    gain_m2 += above_m * above_m - (above_m - line_m) * (above_m - line_m);
    if (gain_m2 <= best_m2) continue;
    best_m2 = gain_m2;
    best = k;
  }
  for (std::ptrdiff_t k = 1; k <= best; ++k) {
    (*label)[static_cast<size_t>(static_cast<std::ptrdiff_t>(border) + k * step)] = true;
  }
}

// Moves the borders between target and support to where the target's slope meets the support.
void RefineBorders(const Heights& heights, const RegionProfile& part, std::vector<bool>* label) {
  for (const PointRange& run : FindRuns(*label, part)) {
    MoveBorder(heights, part, run.begin, -1, run.size(), label);
    MoveBorder(heights, part, run.end - 1, 1, run.size(), label);
  }
}

// Drops the runs whose middle lies outside `extent` of the tangents along the stripe, by more than
// a part of it.
void DropOutside(const RegionProfile& part, const BwCamera& camera, const Extent& extent,
                 std::vector<bool>* label) {
  const int axis = part.laser == sensor::Laser::kVertical ? 1 : 0;
  for (const PointRange& run : FindRuns(*label, part)) {
    const Eigen::Vector3d& middle_m = part.p_L_m[(run.begin + run.end) / 2];
    const double at_1 = Tangents(camera.InCamera(middle_m))[axis];
    if (extent.Holds(at_1, kBeyond_1)) continue;
    for (size_t i = run.begin; i < run.end; ++i) (*label)[i] = false;
  }
}

}  // namespace

ScanLabels LabelPoints(const sensor::ScanSet& scan, const std::optional<VerticalRegion>& region,
                       std::span<const RegionProfile> parts, const BackgroundOptions& options) {
  ScanLabels labels;
  if (options.method == BackgroundMethod::kThesis) {
    for (const RegionProfile& part : parts) {
      std::vector<bool>& label = labels.on_target.emplace_back();
      for (const Eigen::Vector3d& p_L : part.p_L_m) {
        label.push_back(p_L.z() > options.floor_margin_m);
      }
    }
    return labels;
  }
  const BwCamera camera = CameraAtTarget(scan);
  const std::optional<Extent> rows = FindRows(parts, camera);
  const std::optional<Extent> columns = FindColumns(scan, region, options.margin_px);
  const std::vector<StripeBlock> blocks = FindStripeBlocks(scan, region, parts, rows);
  labels.support = FitSupportPlane(blocks, rows ? FindFoot(parts, camera, *rows) : std::nullopt);
  if (labels.support) {
    labels.wall = FindWallPlane(blocks, *labels.support, scan.camera_position_L_m);
  }
  const SupportPlane support = labels.support.value_or(
      SupportPlane{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), kKnownFlat_m, 0});
  for (const RegionProfile& part : parts) {
    const Heights heights = FindHeights(part, support);
    std::vector<double> ratio(part.p_L_m.size());
    for (size_t i = 0; i < ratio.size(); ++i) {
      const double wall_log = labels.wall ? WallLog(*labels.wall, part, i) : kUnknown;
      ratio[i] = LogRatio(heights.above_m[i], heights.sigma_m[i], wall_log);
      if (!part.on_color_1.empty()) ratio[i] += LogColorRatio(part.on_color_1[i]);
    }
    std::vector<bool>& label = labels.on_target.emplace_back(LikeliestLabels(ratio, part));
    RefineBorders(heights, part, &label);
    const bool vertical = part.laser == sensor::Laser::kVertical;
    if (vertical && rows) DropOutside(part, camera, *rows, &label);
    if (!vertical && columns) DropOutside(part, camera, *columns, &label);
  }
  return labels;
}

std::vector<std::vector<bool>> FindTargetPoints(const sensor::ScanSet& scan,
                                                const BackgroundOptions& options) {
  const std::optional<VerticalRegion> region = FindVerticalRegion(scan, options);
  const std::vector<RegionProfile> parts = FindRegionProfiles(scan, region);
  const ScanLabels labels = LabelPoints(scan, region, parts, options);
  std::vector<std::vector<bool>> on_target;
  for (size_t k = 0; k < parts.size(); ++k) {
    const std::vector<int>& pixel = scan.profiles[k].pixel;
    std::vector<bool>& label = on_target.emplace_back(pixel.size(), false);
    size_t at = 0;  // both go through the pixels in order
    for (size_t i = 0; i < pixel.size() && at < parts[k].pixel.size(); ++i) {
      if (pixel[i] == parts[k].pixel[at]) label[i] = labels.on_target[k][at++];
    }
  }
  return on_target;
}

}  // namespace geon::recognition
