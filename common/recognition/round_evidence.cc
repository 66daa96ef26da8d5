#include "recognition/round_evidence.h"

#include <algorithm>
#include <cmath>

#include "recognition/cone_fit.h"

namespace geon::recognition {
namespace {

constexpr size_t kPointsOfStripe = 15;
constexpr double kConeTolerance_1 = 0.006;  // of the scale
constexpr double kNoises = 1.5;
constexpr double kLeastSigma_1 = 0.003;  // no slope is known better

struct Sample {
  std::vector<Eigen::Vector3d> points_m;
  double noise_m = 0.0;
};

// Evenly along every stripe.
Sample SamplePoints(const std::vector<TargetStripe>& stripes) {
  Sample sample;
  double seen = 0.0;
  for (const TargetStripe& stripe : stripes) {
    if (stripe.empty()) continue;
    seen += 1.0;
    sample.noise_m += stripe.noise_m;
    const size_t n = stripe.p_L_m.size();
    const size_t count = std::min(kPointsOfStripe, n);
    for (size_t k = 0; k < count; ++k) {
      sample.points_m.push_back(stripe.p_L_m[(2 * k + 1) * n / (2 * count)]);
    }
  }
  sample.noise_m /= std::max(seen, 1.0);
  return sample;
}

std::vector<OrientedPoint> Oriented(const CrossingGrid& grid) {
  std::vector<OrientedPoint> points;
  for (const auto& row : grid) {
    for (const auto& crossing : row) {
      if (crossing) points.push_back({crossing->p_L_m, crossing->normal_L});
    }
  }
  return points;
}

}  // namespace

void AddRoundEvidence(const std::vector<TargetStripe>& stripes, const CrossingGrid& grid,
                      double scale_m, EvidenceList* evidence) {
  const Sample sample = SamplePoints(stripes);
  Cone cone = FitCone(sample.points_m, Oriented(grid),
                      std::max(kNoises * sample.noise_m, kConeTolerance_1 * scale_m));
  if (cone.axis_L.z() < 0.0) {
    cone.axis_L = -cone.axis_L;
    cone.slope_1 = -cone.slope_1;
  }
  double lowest_m = 0.0, highest_m = 0.0;
  for (const Eigen::Vector3d& p_m : sample.points_m) {
    const double along_m = cone.axis_L.dot(p_m - cone.p_L_m);
    lowest_m = std::min(lowest_m, along_m);
    highest_m = std::max(highest_m, along_m);
  }
  const double extent_m = highest_m - lowest_m;
  const double radius_m = std::max(cone.radius_m, 0.01 * scale_m);
  evidence->Add("misfit", cone.misfit_1);
  evidence->Add("slope", cone.slope_1);
  evidence->Add("taper", std::abs(cone.slope_1));
  evidence->Add("taper_sigma", std::min(cone.slope_sigma_1, 1.0));
  evidence->Add("taper_sigmas", std::abs(cone.slope_1) / (cone.slope_sigma_1 + kLeastSigma_1));
  evidence->Add("growth", std::min(std::abs(cone.slope_1) * extent_m / radius_m, 5.0));
  evidence->Add("radius", std::min(radius_m / scale_m, 10.0));
  evidence->Add("length", std::min(extent_m / scale_m, 10.0));
  evidence->Add("axis_up", cone.axis_L.z());
}

}  // namespace geon::recognition
