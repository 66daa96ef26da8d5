#include "recognition/profile_curve.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

sensor::RangeProfile Part(const sensor::RangeProfile& profile, size_t begin, size_t end) {
  sensor::RangeProfile part = profile;
  const auto b = static_cast<std::ptrdiff_t>(begin);
  const auto e = static_cast<std::ptrdiff_t>(end);
  part.pixel.assign(profile.pixel.begin() + b, profile.pixel.begin() + e);
  part.p_L_m.assign(profile.p_L_m.begin() + b, profile.p_L_m.begin() + e);
  return part;
}

double Extent(const sensor::RangeProfile& part) {
  return (part.p_L_m.back() - part.p_L_m.front()).norm();
}

// Mean of the curve between the arc lengths `begin_m` and `end_m`: the integral of its straight
// pieces. `piece` is the first piece that may reach past begin_m; it moves on with the walk.
Eigen::Vector2d MeanOverArc(std::span<const Eigen::Vector2d> curve_m,
                            const std::vector<double>& arc_m, double begin_m, double end_m,
                            size_t* piece) {
  Eigen::Vector2d integral = Eigen::Vector2d::Zero();
  double covered_m = 0.0;
  while (*piece + 2 < arc_m.size() && arc_m[*piece + 1] <= begin_m) ++*piece;
  for (size_t k = *piece; k + 1 < arc_m.size() && arc_m[k] < end_m; ++k) {
    const double length_m = arc_m[k + 1] - arc_m[k];
    const double from_m = std::max(begin_m, arc_m[k]);
    const double to_m = std::min(end_m, arc_m[k + 1]);
    if (length_m <= 0.0 || to_m <= from_m) continue;
    const double t = (0.5 * (from_m + to_m) - arc_m[k]) / length_m;
    integral += (to_m - from_m) * (curve_m[k] + t * (curve_m[k + 1] - curve_m[k]));
    covered_m += to_m - from_m;
  }
  return covered_m > 0.0 ? Eigen::Vector2d(integral / covered_m) : curve_m[*piece];
}

}  // namespace

void SegmentOptions::Validate() const {
  Require(split_m > 0.0, "split_m is " + std::to_string(split_m) + ", must be positive");
  Require(shortest_m >= 0.0,
          "shortest_m is " + std::to_string(shortest_m) + ", must not be negative");
  Require(shortest_share_1 >= 0.0 && shortest_share_1 < 1.0,
          "shortest_share_1 is " + std::to_string(shortest_share_1) + ", must be in [0, 1)");
  Require(fewest_points >= 2,
          "fewest_points is " + std::to_string(fewest_points) + ", must be at least 2");
}

std::vector<sensor::RangeProfile> SplitIntoSegments(const sensor::RangeProfile& profile,
                                                    const SegmentOptions& options) {
  std::vector<sensor::RangeProfile> segments;
  double longest_m = 0.0;
  size_t begin = 0;
  for (size_t i = 0; i < profile.pixel.size(); ++i) {
    const bool last = i + 1 == profile.pixel.size();
    if (!last && (profile.p_L_m[i + 1] - profile.p_L_m[i]).norm() <= options.split_m) continue;
    segments.push_back(Part(profile, begin, i + 1));
    longest_m = std::max(longest_m, Extent(segments.back()));
    begin = i + 1;
  }
  const double shortest_m = std::max(options.shortest_m, options.shortest_share_1 * longest_m);
  std::erase_if(segments, [&](const sensor::RangeProfile& part) {
    return static_cast<int>(part.pixel.size()) < options.fewest_points || Extent(part) < shortest_m;
  });
  return segments;
}

std::vector<Eigen::Vector2d> PlaneCurve(const sensor::RangeProfile& profile,
                                        const Eigen::Matrix3d& R_LB) {
  const Eigen::Vector3d along_L =
      profile.laser == sensor::Laser::kVertical ? R_LB.col(1) : R_LB.col(0);
  std::vector<Eigen::Vector2d> curve_m;
  curve_m.reserve(profile.p_L_m.size());
  for (const Eigen::Vector3d& p_L : profile.p_L_m) {
    curve_m.emplace_back(along_L.dot(p_L), -R_LB.col(2).dot(p_L));
  }
  return curve_m;
}

std::vector<Eigen::Vector2d> ResampleEqualArc(std::span<const Eigen::Vector2d> curve_m,
                                              int samples) {
  Require(samples >= 2,
          "ResampleEqualArc needs at least 2 samples, got " + std::to_string(samples));
  Require(curve_m.size() >= 2, "ResampleEqualArc needs at least 2 points");
  std::vector<double> arc_m(curve_m.size(), 0.0);
  for (size_t i = 1; i < curve_m.size(); ++i) {
    arc_m[i] = arc_m[i - 1] + (curve_m[i] - curve_m[i - 1]).norm();
  }
  const double step_m = arc_m.back() / samples;
  std::vector<Eigen::Vector2d> resampled_m;
  resampled_m.reserve(static_cast<size_t>(samples));
  size_t piece = 0;
  for (int k = 0; k < samples; ++k) {
    resampled_m.push_back(MeanOverArc(curve_m, arc_m, k * step_m, (k + 1) * step_m, &piece));
  }
  return resampled_m;
}

double ArcLength(std::span<const Eigen::Vector2d> curve_m) {
  double length_m = 0.0;
  for (size_t i = 1; i < curve_m.size(); ++i) length_m += (curve_m[i] - curve_m[i - 1]).norm();
  return length_m;
}

}  // namespace geon::recognition
