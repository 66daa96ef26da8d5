#include "recognition/support_plane.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "base/angles.h"
#include "recognition/median.h"

namespace geon::recognition {
namespace {

constexpr int kFewestOnSupport = 40;
constexpr double kTiltPrior_rad = RadiansFromDegrees(2.0);
constexpr double kOffsetPrior_m = 0.01;
constexpr double kFoot_m = 0.03;       // sigma of the target's foot above its support
constexpr double kNear_m = 1.0;        // of the foot: beyond may be another plane
constexpr double kGateSigmas = 2.5;    // of the prior: what may lie on the support
constexpr double kSteepest_1 = 0.3;    // of a block's direction: steeper is no support
constexpr size_t kEnoughBeside = 12;   // blocks beside the target
constexpr double kFlat_m = 0.002;      // what a support is expected to be off a plane
constexpr double kOnSigmas = 3.0;      // of flatness and noise: what lies on a plane
constexpr double kBelowCounts = 10.0;  // a block below a plane outweighs so many on it
constexpr double kRoughest_m = 0.004;  // a support is flatter than that
constexpr int kSamples = 30;
constexpr size_t kEnough = 100;      // of more blocks only every n-th is looked at
constexpr double kCorrelated = 4.0;  // neighbouring blocks err alike: so many count as one
constexpr std::array<double, 4> kTukeySigmas = {6.0, 4.0, 3.5, 3.5};

// A plane z = c0 + c1 x + c2 y of frame L.
using Coefficients = Eigen::Vector3d;

double HeightAbove(const Coefficients& plane, const Eigen::Vector3d& p_m) {
  return p_m.z() - plane.dot(Eigen::Vector3d(1.0, p_m.x(), p_m.y()));
}

// A block as the fit sees it.
struct Sample {
  Eigen::Vector3d p_m;
  double sigma_m = 0.0;  // of its height above a plane
  int points = 0;
  bool beside = false;
};

std::vector<Sample> SamplesNearSupport(std::span<const StripeBlock> blocks,
                                       const std::optional<Eigen::Vector3d>& foot_L_m) {
  std::vector<Sample> samples;
  for (const StripeBlock& block : blocks) {
    if (block.place == BlockPlace::kOnTarget) continue;
    if (foot_L_m && (block.p_L_m - *foot_L_m).norm() > kNear_m) continue;
    const double gate_m =
        kGateSigmas * std::hypot(kOffsetPrior_m, kTiltPrior_rad * block.p_L_m.head<2>().norm());
    if (std::abs(block.p_L_m.z()) > gate_m || std::abs(block.along_L.z()) > kSteepest_1) continue;
    samples.push_back({block.p_L_m, std::hypot(kFlat_m, block.noise_m / std::sqrt(block.points)),
                       block.points, block.place == BlockPlace::kBeside});
  }
  const size_t every = samples.size() / kEnough + 1;
  for (size_t i = 0; i * every < samples.size(); ++i) {
    samples[i] = samples[i * every];
    samples[i].points *= static_cast<int>(every);
  }
  samples.resize((samples.size() + every - 1) / every);
  return samples;
}

Eigen::Matrix3d PriorInformation() {
  const double tilt = 1.0 / (kTiltPrior_rad * kTiltPrior_rad);
  return Eigen::Vector3d(1.0 / (kOffsetPrior_m * kOffsetPrior_m), tilt, tilt).asDiagonal();
}

// Least squares with the prior; samples of weight 0 do not count.
class PlaneFit {
 public:
  void Add(const Sample& sample, double weight) {
    const Eigen::Vector3d row(1.0, sample.p_m.x(), sample.p_m.y());
    const double information = weight / (sample.sigma_m * sample.sigma_m);
    information_ += information * row * row.transpose();
    right_ += information * sample.p_m.z() * row;
  }
  Coefficients Solve() const { return information_.ldlt().solve(right_); }

 private:
  Eigen::Matrix3d information_ = PriorInformation();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

// How well a plane agrees with the samples, the prior and the target's foot: the samples on it less
// those below.
double Score(const Coefficients& plane, std::span<const Sample> samples,
             const std::optional<Eigen::Vector3d>& foot_L_m) {
  static const Eigen::Matrix3d prior = PriorInformation();
  double score = -0.5 * plane.dot(prior * plane);
  if (foot_L_m) score -= 0.5 * std::pow(HeightAbove(plane, *foot_L_m) / kFoot_m, 2);
  for (const Sample& sample : samples) {
    const double share = HeightAbove(plane, sample.p_m) / (kOnSigmas * sample.sigma_m);
    if (share > 1.0) continue;
    score += share < -1.0 ? -kBelowCounts : 1.0 - share * share;
  }
  return score;
}

Coefficients BestPlane(std::span<const Sample> samples,
                       const std::optional<Eigen::Vector3d>& foot_L_m) {
  std::minstd_rand random(1);  // always the same samples
  Coefficients best = Coefficients::Zero();
  double best_score = Score(best, samples, foot_L_m);
  for (int k = 0; k < kSamples; ++k) {
    PlaneFit fit;
    for (int i = 0; i < 3; ++i) fit.Add(samples[random() % samples.size()], 1.0);
    const Coefficients plane = fit.Solve();
    const double score = Score(plane, samples, foot_L_m);
    if (score <= best_score) continue;
    best_score = score;
    best = plane;
  }
  return best;
}

Coefficients Refine(Coefficients plane, std::span<const Sample> samples) {
  for (double sigmas : kTukeySigmas) {
    PlaneFit fit;
    for (const Sample& sample : samples) {
      const double share = HeightAbove(plane, sample.p_m) / (sigmas * sample.sigma_m);
      const double inside = 1.0 - share * share;
      if (inside > 0.0) fit.Add(sample, inside * inside / kCorrelated);
    }
    plane = fit.Solve();
  }
  return plane;
}

}  // namespace

std::optional<SupportPlane> FitSupportPlane(std::span<const StripeBlock> blocks,
                                            const std::optional<Eigen::Vector3d>& foot_L_m) {
  const std::vector<Sample> samples = SamplesNearSupport(blocks, foot_L_m);
  if (samples.empty()) return std::nullopt;
  std::vector<Sample> beside;
  for (const Sample& sample : samples) {
    if (sample.beside) beside.push_back(sample);
  }
  const Coefficients plane =
      Refine(BestPlane(beside.size() >= kEnoughBeside ? beside : samples, foot_L_m), samples);

  SupportPlane support;
  Eigen::Vector3d sum_m = Eigen::Vector3d::Zero();
  std::vector<double> off_m;
  for (const Sample& sample : samples) {
    const double above_m = std::abs(HeightAbove(plane, sample.p_m));
    if (above_m > kTukeySigmas.back() * sample.sigma_m) continue;
    off_m.push_back(above_m);
    support.points += sample.points;
    sum_m += sample.points * sample.p_m;
  }
  if (support.points < kFewestOnSupport) return std::nullopt;
  const Eigen::Vector3d middle_m = sum_m / support.points;
  support.p_L_m = middle_m - HeightAbove(plane, middle_m) * Eigen::Vector3d::UnitZ();
  support.normal_L = Eigen::Vector3d(-plane[1], -plane[2], 1.0).normalized();
  constexpr double kMedianOfMagnitude = 0.6745;  // of a normal variable, in sigmas
  support.sigma_m = Median(std::move(off_m)) / kMedianOfMagnitude;
  if (support.sigma_m > kRoughest_m) return std::nullopt;
  return support;
}

geometry::RigidTransform LevelOn(const SupportPlane& plane) {
  const Eigen::Vector3d foot_m(plane.p_L_m.x(), plane.p_L_m.y(), 0.0);
  return Eigen::Translation3d(foot_m) *
         Eigen::Quaterniond::FromTwoVectors(plane.normal_L, Eigen::Vector3d::UnitZ()) *
         Eigen::Translation3d(-plane.p_L_m);
}

}  // namespace geon::recognition
