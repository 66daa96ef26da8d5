#include "evaluation/stripe_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angles.h"

namespace geon::evaluation {
namespace {

constexpr double kNoDepth_m = std::numeric_limits<double>::infinity();
constexpr double kSpeckleLength_px = 4.0;
constexpr double kOutlierReach_px = 20.0;
constexpr double kJump_m = 0.03;   // a larger step is a jump of depth
constexpr double kMixes_1 = 0.02;  // of lines beside a jump mix both sides
constexpr int kWaves = 3;
constexpr double kImage_px = 640.0;

// A first-order autoregression of deviation 1.
class Autoregression {
 public:
  Autoregression(double length_px, std::mt19937_64& random)
      : memory_(std::exp(-1.0 / length_px)), state_(gauss_(random)) {}
  double Next(std::mt19937_64& random) {
    state_ = memory_ * state_ + std::sqrt(1.0 - memory_ * memory_) * gauss_(random);
    return state_;
  }

 private:
  std::normal_distribution<double> gauss_;
  double memory_;
  double state_;
};

// Mean over a patch, of the depths that belong to the surface in its middle; now and then of all.
double PatchMean(std::span<const double> depths_m, std::ptrdiff_t middle, int half, bool mixes) {
  const double depth_m = depths_m[static_cast<size_t>(middle)];
  if (!std::isfinite(depth_m)) return depth_m;
  const auto last = static_cast<std::ptrdiff_t>(depths_m.size()) - 1;
  double sum_m = 0.0, count = 0.0;
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(middle - half, 0);
       i <= std::min(middle + half, last); ++i) {
    const double other_m = depths_m[static_cast<size_t>(i)];
    if (!std::isfinite(other_m) || (!mixes && std::abs(other_m - depth_m) > kJump_m)) continue;
    sum_m += other_m;
    count += 1.0;
  }
  return sum_m / count;
}

std::vector<double> PatchMeans(std::span<const double> depths_m, int half,
                               std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform;
  std::vector<double> means_m;
  for (size_t i = 0; i < depths_m.size(); ++i) {
    const bool mixes = uniform(random) < kMixes_1;
    means_m.push_back(PatchMean(depths_m, static_cast<std::ptrdiff_t>(i), half, mixes));
  }
  return means_m;
}

// Removes the lines whose depth differs by more than this from that of a neighbour, jumps aside.
void LoseSteep(std::span<const double> before_m, double steepest_m, std::vector<double>* depths_m) {
  for (size_t i = 1; i < before_m.size(); ++i) {
    const double step_m = std::abs(before_m[i] - before_m[i - 1]);
    if (step_m > steepest_m && step_m <= kJump_m) {
      (*depths_m)[i - 1] = (*depths_m)[i] = kNoDepth_m;
    }
  }
}

// Whether a surface ends between two neighbouring lines.
bool IsEdge(double a_m, double b_m) {
  if (std::isfinite(a_m) != std::isfinite(b_m)) return true;
  return std::isfinite(a_m) && std::abs(a_m - b_m) > kJump_m;
}

// Each edge moves by a draw of its own: what grows goes on at the depth of its last line. Then up
// to `shadow_px` lines are lost on either side.
void MoveEdges(std::span<const double> before_m, const FaultOptions& faults,
               std::mt19937_64& random, std::vector<double>* depths_m) {
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> uniform;
  const auto lines = static_cast<std::ptrdiff_t>(before_m.size());
  const auto fill = [&](std::ptrdiff_t begin, std::ptrdiff_t end, double depth_m) {
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(begin, 0); k < std::min(end, lines); ++k) {
      (*depths_m)[static_cast<size_t>(k)] = depth_m;
    }
  };
  for (std::ptrdiff_t i = 1; i < lines; ++i) {
    const double left_m = before_m[static_cast<size_t>(i - 1)];
    const double right_m = before_m[static_cast<size_t>(i)];
    if (!IsEdge(left_m, right_m)) continue;
    const std::ptrdiff_t edge = i + std::lround(faults.edge_px * gauss(random));
    fill(i, edge, left_m);
    fill(edge, i, right_m);
    const std::ptrdiff_t after = std::lround(faults.shadow_px * uniform(random));
    const std::ptrdiff_t before = std::lround(faults.shadow_px * uniform(random));
    fill(edge - before, edge + after, kNoDepth_m);
  }
}

}  // namespace

std::vector<StripeError> StripeErrors(size_t lines, const FaultOptions& faults,
                                      std::mt19937_64& random) {
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> uniform;
  Autoregression speckle(kSpeckleLength_px, random);
  std::vector<StripeError> errors(lines);
  for (StripeError& error : errors) {
    error.offset_px = faults.noise_px * gauss(random);
    if (faults.speckle_px > 0.0) {
      error.offset_px += faults.speckle_px * speckle.Next(random);
    }
    if (faults.outliers_1 > 0.0 && uniform(random) < faults.outliers_1) {
      error.offset_px = kOutlierReach_px * (2.0 * uniform(random) - 1.0);
    }
    error.missing = faults.dropout_1 > 0.0 && uniform(random) < faults.dropout_1;
  }
  return errors;
}

OffsetError::OffsetError(const FaultOptions& faults, std::mt19937_64& random) {
  std::normal_distribution<double> gauss;
  if (faults.offset_px > 0.0) offset_px_ = faults.offset_px * gauss(random);
  if (faults.ripple_px <= 0.0) return;
  std::uniform_real_distribution<double> uniform;
  for (int k = 0; k < kWaves; ++k) {
    Wave wave;
    wave.height_px = faults.ripple_px * std::sqrt(2.0 / kWaves) * gauss(random);
    const double direction_rad = 2.0 * kPi * uniform(random);
    wave.number_per_px = (1.0 + uniform(random)) * 2.0 * kPi / kImage_px *
                         Eigen::Vector2d(std::cos(direction_rad), std::sin(direction_rad));
    wave.phase_rad = 2.0 * kPi * uniform(random);
    waves_.push_back(wave);
  }
}

double OffsetError::At(const Eigen::Vector2d& place_px) const {
  double error_px = offset_px_;
  for (const Wave& wave : waves_) {
    error_px += wave.height_px * std::sin(wave.number_per_px.dot(place_px) + wave.phase_rad);
  }
  return error_px;
}

std::vector<double> MatchPatches(std::span<const double> depths_m, const FaultOptions& faults,
                                 std::mt19937_64& random) {
  std::vector<double> seen_m(depths_m.begin(), depths_m.end());
  const int half = static_cast<int>(std::lround(faults.patch_px));
  if (half > 0) seen_m = PatchMeans(depths_m, half, random);
  if (faults.steepest_m > 0.0) LoseSteep(std::vector(seen_m), faults.steepest_m, &seen_m);
  if (faults.edge_px > 0.0 || faults.shadow_px > 0.0) {
    MoveEdges(std::vector(seen_m), faults, random, &seen_m);
  }
  return seen_m;
}

}  // namespace geon::evaluation
